// What generator threads call to make terrain. Every function may be called by several threads at once
// and may throw std::bad_alloc.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <talus/terrain/extraction.h>
#include <talus/terrain/heights.h>
#include <talus/terrain/stacks.h>
#include <talus/voxel/coords.h>

#include "cache/encoded_chunk.h"
#include "generation/patch.h"

namespace talus::server {

class Generator {
 public:
  virtual ~Generator() = default;

  /// The chunk where it costs nothing to know it; else null.
  [[nodiscard]] virtual EncodedChunkPtr instant(ChunkKey key) const = 0;
  /// The chunk that is of one material, air among them.
  [[nodiscard]] virtual EncodedChunkPtr uniform(MaterialId material) const = 0;
  /// Rows of chunks outside which every chunk of a column is uniform, for all that is known without looking.
  [[nodiscard]] virtual terrain::MixedRange rows_anywhere(Lod lod) const = 0;
  /// The same of the column of a chunk over this patch, exactly.
  [[nodiscard]] virtual terrain::MixedRange rows(const terrain::Stacks& stacks, ChunkKey key) const = 0;
  /// Into `stacks`, whose memory is used again.
  virtual void make_patch(const PatchKey& patch, terrain::Stacks& stacks) const = 0;
  /// `stacks` is the patch over which the chunk stands.
  [[nodiscard]] virtual EncodedChunkPtr make_chunk(const terrain::Stacks& stacks, ChunkKey key) const = 0;
  /// Surface heights in subvoxels, one a column.
  [[nodiscard]] virtual std::vector<std::int32_t> heights(
      std::span<const terrain::BaseColumn> columns) const = 0;
};

}  // namespace talus::server
