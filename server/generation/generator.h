// What generator threads call to make terrain. Any function may be called by several threads at once, and may
// throw std::bad_alloc. Equal arguments give equal chunks, for ever: nothing made from them needs to be
// invalidated.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <talus/terrain/extraction.h>
#include <talus/terrain/heights.h>
#include <talus/terrain/stacks.h>
#include <talus/voxel/coords.h>

#include "chunks/chunk_source.h"
#include "chunks/encoded_chunk.h"
#include "generation/patch.h"

namespace talus::server {

/// Asked between pieces of work of some milliseconds; false: it is not wanted any more.
using GoOn = std::function<bool()>;

class Generator {
 public:
  virtual ~Generator() = default;

  /// The chunk where it costs nothing to know it; else null.
  [[nodiscard]] virtual EncodedChunkPtr instant(ChunkKey key) const = 0;
  /// The chunk that is of one material, air among them.
  [[nodiscard]] virtual EncodedChunkPtr uniform(MaterialId material) const = 0;
  /// Of any column of the level, for all that is known without looking.
  [[nodiscard]] virtual MixedRows mixed_rows_anywhere(Lod lod) const = 0;
  /// Of the key's column over this patch, exactly.
  [[nodiscard]] virtual MixedRows mixed_rows(const terrain::Stacks& stacks, ChunkKey key) const = 0;
  /// Fills `stacks`, whose memory is reused. False where go_on() ended it; then they mean nothing.
  [[nodiscard]] virtual bool make_patch(const PatchKey& patch, terrain::Stacks& stacks,
                                        const GoOn& go_on) const = 0;
  /// `stacks` is the patch over which the chunk stands.
  [[nodiscard]] virtual EncodedChunkPtr make_chunk(const terrain::Stacks& stacks, ChunkKey key) const = 0;
  /// Surface heights in subvoxels (1/256 voxel), one a column; none where go_on() ended it.
  [[nodiscard]] virtual std::optional<std::vector<std::int32_t>> heights(
      std::span<const terrain::BaseColumn> columns, const GoOn& go_on) const = 0;
};

}  // namespace talus::server
