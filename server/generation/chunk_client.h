// Who waits for chunks and heights.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include <talus/terrain/heights.h>
#include <talus/voxel/coords.h>

#include "cache/encoded_chunk.h"

namespace talus::server {

/// The generator could not answer (out of memory); asking again may help.
struct GenerationFailed {
  std::string reason;
};
using ChunkAnswer = tl::expected<EncodedChunkPtr, GenerationFailed>;
using HeightsAnswer = tl::expected<std::vector<std::int32_t>, GenerationFailed>;

struct ReadyChunk {
  ChunkKey key;
  ChunkAnswer answer;
};

/// Called on any thread, mostly a generator's: hand the answers over to your own thread and return.
class ChunkClient {
 public:
  virtual ~ChunkClient() = default;
  virtual void chunks_ready(std::vector<ReadyChunk> chunks) = 0;
  virtual void heights_ready(std::uint64_t ticket, HeightsAnswer answer) = 0;
};
using ChunkClientPtr = std::shared_ptr<ChunkClient>;

/// Columns whose heights `client` waits for. It never gives a ticket twice, so that an answer which a
/// cancellation missed is told from a later one.
struct HeightsTask {
  ChunkClientPtr client;
  std::uint64_t ticket = 0;
  std::vector<terrain::BaseColumn> columns;
};

}  // namespace talus::server
