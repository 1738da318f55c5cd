#include "chunks/generation/patch.h"

#include <cassert>

namespace talus::server {

PatchKey patch_of(ChunkKey chunk, int patch_tiles) {
  assert(is_patch_edge(patch_tiles));
  return {static_cast<std::int32_t>(floor_div(chunk.coord.x, patch_tiles)),
          static_cast<std::int32_t>(floor_div(chunk.coord.z, patch_tiles)), chunk.lod};
}

terrain::Region region_of(const PatchKey& patch, int patch_tiles) {
  const int columns = patch_tiles * kChunkSize;
  return {std::int64_t{patch.x} * columns, std::int64_t{patch.z} * columns, columns, columns, patch.lod};
}

}  // namespace talus::server
