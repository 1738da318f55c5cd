// Voxels of one chunk as bytes, for the store, the log and the wire: ../../../FORMAT.md, "Runs". Every set of
// voxels has one encoding, so equal sets have equal bytes and equal hashes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include <talus/voxel/chunk.h>

namespace talus::edits {

enum class RunsError : std::uint8_t {
  truncated,      // the bytes end before the runs do
  too_long,       // bytes follow the last run
  bad_number,     // a varint has more bytes than it needs, or a value past its range
  bad_materials,  // the ids do not rise, or a run is not of one of them, or one of them is in no run
  split_run,      // a run is of the material of the run that it touches
  past_chunk,     // a run ends past the chunk's last voxel
  too_many,       // there are more voxels than the caller takes
};

/// One line for people: what is wrong, and what would be right.
[[nodiscard]] std::string_view describe(RunsError error);

/// Appends `voxels`. REQUIRES: indices rise, each once, below kChunkVolume (asserted).
void encode_runs(std::span<const Override> voxels, std::vector<std::byte>& out);

/// Reads a whole block. Any bytes are safe: what encode_runs would not have written is an error, counts are
/// checked against the bytes that are left before memory is taken for them, and what is returned, by rising
/// index, holds at most `most_voxels`, which are counted before they are spread out.
[[nodiscard]] tl::expected<std::vector<Override>, RunsError> decode_runs(
    std::span<const std::byte> bytes, std::size_t most_voxels = kChunkVolume);

}  // namespace talus::edits
