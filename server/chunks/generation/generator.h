// The functions that generator threads call to make terrain. Several threads may call any of them at once,
// and each may throw std::bad_alloc. Equal arguments give equal chunks, for ever: nothing made from them
// needs to be invalidated.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include <talus/terrain/extraction.h>
#include <talus/terrain/heights.h>
#include <talus/terrain/stacks.h>
#include <talus/voxel/coords.h>

#include "chunks/chunk_source.h"
#include "chunks/encoded_chunk.h"
#include "chunks/generation/patch.h"

namespace talus::server {

/// Something that is made step by step. For one thread at a time, not always the same; the destructor gives
/// it up. Steps may throw std::bad_alloc, and then only the destructor may be called.
template <typename Product>
class Build {
 public:
  virtual ~Build() = default;
  /// Does some milliseconds of work. Returns false when nothing is left.
  [[nodiscard]] virtual bool step() = 0;
  /// Call it after step() has returned false.
  [[nodiscard]] virtual Product take() = 0;
};
using PatchBuild = Build<terrain::Stacks>;
using HeightsBuild = Build<HeightsResult>;

/// Decision after a step.
enum class AfterStep { go_on, pause, give_up };
using AskAfterStep = std::function<AfterStep()>;

class Generator {
 public:
  virtual ~Generator() = default;

  /// Returns the chunk if it is known at no cost; else null.
  [[nodiscard]] virtual EncodedChunkPtr instant(ChunkKey key) const = 0;
  /// Returns the chunk that is of one material, which may be air.
  [[nodiscard]] virtual EncodedChunkPtr uniform(MaterialId material) const = 0;
  /// Returns the rows of any column of the level, without examining one.
  [[nodiscard]] virtual MixedRows mixed_rows_anywhere(Lod lod) const = 0;
  /// Returns the exact rows of the key's column over this patch.
  [[nodiscard]] virtual MixedRows mixed_rows(const terrain::Stacks& stacks, ChunkKey key) const = 0;
  /// `memory` is reused. The generator outlives what it makes.
  [[nodiscard]] virtual std::unique_ptr<PatchBuild> start_patch(const PatchKey& patch,
                                                                terrain::Stacks memory) const = 0;
  /// `stacks` is the patch over which the chunk stands.
  [[nodiscard]] virtual EncodedChunkPtr make_chunk(const terrain::Stacks& stacks, ChunkKey key) const = 0;
  [[nodiscard]] virtual std::unique_ptr<HeightsBuild> start_heights(HeightsQuery query) const = 0;
};

}  // namespace talus::server
