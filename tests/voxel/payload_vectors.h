// What core/voxel/vectors/payloads.txt, tests/voxel/golden and FORMAT.md's worked examples are made of.
#pragma once

#include <string>
#include <vector>

#include <talus/voxel/chunk.h>
#include <talus/voxel/codec.h>

namespace talus::testing {

struct WorkedExample {
  std::string name;
  Chunk chunk;
  std::vector<std::byte>
      payload;  // what encode gives; of runs, which it would not choose here, what it could
};
/// The chunks of FORMAT.md's worked examples, in its order.
[[nodiscard]] std::vector<WorkedExample> worked_examples();

struct FrozenChunk {
  std::string name;
  Chunk chunk;
  std::string hash;
};
/// The chunks whose payloads of version 4 are frozen in golden/v4.
[[nodiscard]] std::vector<FrozenChunk> frozen_chunks();

/// The whole of core/voxel/vectors/payloads.txt.
[[nodiscard]] std::string payload_vectors();

/// "truncated" and so on, as core/voxel/vectors/payloads.txt and FORMAT.md name errors.
[[nodiscard]] std::string name_of(DecodeError error);

}  // namespace talus::testing
