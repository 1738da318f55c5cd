// Edits of one player on a world, in memory. Everything follows core/edits: an edit here does what a server
// would do.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include <tl/expected.hpp>

#include <talus/edits/chunk_overrides.h>
#include <talus/edits/edit.h>
#include <talus/edits/evaluate.h>
#include <talus/edits/materials.h>
#include <talus/edits/state_hash.h>
#include <talus/local/local.h>
#include <talus/voxel/material.h>

namespace talus::local {

struct EditOutcome {
  std::optional<std::size_t> conflict;  // the first guard that does not hold; nothing changed then
  std::size_t changed = 0;              // voxels of level 0
  std::vector<ChunkKey> chunks;         // that changed, of all levels, each once
};

/// Id of a world's placeable material, by its index in World::placeables(), if no store or save has given it
/// another.
[[nodiscard]] MaterialId placeable_id(std::size_t index);

/// Ids of World::placeables(), in order: those of `known` by name, and the next ones for new names. nullopt
/// if ids are exhausted.
[[nodiscard]] std::optional<std::vector<MaterialId>> placeable_ids(const World& world,
                                                                   const edits::MaterialIds& known);

/// Ids of all materials of a world by name: those that it generates, and placeable_ids().
[[nodiscard]] std::optional<edits::MaterialIds> material_ids(const World& world,
                                                             const edits::MaterialIds& known = {});

struct EditSettings {
  /// Loose material falls and slides after an edit, as with talusd's setting edits.settle.
  bool settles = false;
  /// Ids of World::placeables(), in order; empty: placeable_id() of each.
  std::vector<MaterialId> placeables;
};

/// Not thread-safe; any number of threads may use const methods while none modifies it.
class Edits final : private edits::OverrideSource {
 public:
  Edits() = default;
  explicit Edits(EditSettings settings) : settings_{std::move(settings)} {}

  /// Applies an edit whole or not at all; an error names what `workspace`'s world forbids. Generates the
  /// chunks that it touches or may settle.
  tl::expected<EditOutcome, edits::EditError> apply(Workspace& workspace, const edits::Edit& edit);

  /// A chunk as generated, with its edits.
  [[nodiscard]] Chunk merged_over(ChunkKey key, const Chunk& generated) const;

  /// Chunks of level 0 that have overrides, by rising x, y, z: all that restore() needs to know.
  [[nodiscard]] std::vector<ChunkCoord> changed_chunks() const;
  /// Overrides of a chunk of level 0 as runs (core/edits/FORMAT.md); the empty set if it has none.
  [[nodiscard]] std::vector<std::byte> overrides(ChunkCoord chunk) const;
  /// Replaces a chunk's overrides by what overrides() returned, at coarser levels too. Returns the chunks
  /// that changed, of all levels. Bytes that are not such runs, and voxels that no edit of `world` could have
  /// written, are an error that changes nothing.
  tl::expected<std::vector<ChunkKey>, edits::EditError> restore(const World& world, ChunkCoord chunk,
                                                                std::span<const std::byte> runs);

  /// S of core/edits/FORMAT.md: equal hashes mean equal edits.
  [[nodiscard]] edits::StateHash hash() const { return hash_; }
  [[nodiscard]] const EditSettings& settings() const { return settings_; }

 private:
  [[nodiscard]] const edits::ChunkOverrides* find(ChunkKey chunk) const override;
  [[nodiscard]] std::vector<MaterialId> writable_in(const World& world) const;
  /// All or, if memory runs out, nothing. Returns the chunks written.
  std::vector<ChunkKey> write(std::span<const edits::ChunkWrites> writes);

  EditSettings settings_;
  std::unordered_map<ChunkKey, edits::ChunkOverrides> overrides_;  // empty ones count for none
  edits::StateHash hash_;
};

}  // namespace talus::local
