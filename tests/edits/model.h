// What edits do, said as simply as can be: one map from voxels to materials. And a state of the real kind to
// compare it with.
#pragma once

#include <map>
#include <optional>
#include <unordered_map>

#include <talus/edits/evaluate.h>
#include <talus/edits/staging.h>
#include <talus/edits/state_hash.h>

namespace talus::edits::testing {

/// A world as generated, of materials 0 to 4: some of everything near every place.
[[nodiscard]] MaterialId base_at(VoxelPos voxel);

/// The base of what `edit` touches, which a node looks up before it logs.
[[nodiscard]] BaseVoxels base_of(const Edit& edit);

class Model {
 public:
  struct Result {
    std::optional<std::size_t> conflict;
    std::size_t changed = 0;
    bool operator==(const Result&) const = default;
  };

  Result apply(const Edit& edit);
  [[nodiscard]] MaterialId at(VoxelPos voxel) const;
  /// Voxels unlike the base.
  [[nodiscard]] const std::map<VoxelPos, MaterialId>& overrides() const { return overrides_; }

 private:
  std::map<VoxelPos, MaterialId> overrides_;
};

/// Chunks of all levels in memory, and S.
struct State final : OverrideSource {
  std::unordered_map<ChunkKey, ChunkOverrides> chunks;
  StateHash hash;

  [[nodiscard]] const ChunkOverrides* find(ChunkKey chunk) const override;
  void commit(const StagingArea& staging);
  void write(const std::unordered_map<ChunkKey, StagedChunk>& staged);
  /// Overrides of one level, by voxel of that level.
  [[nodiscard]] std::map<VoxelPos, MaterialId> overrides(Lod lod) const;
};

/// An edit of a few operations near one of several places: borders of chunks, the world's ends. Draws by
/// rapidcheck.
[[nodiscard]] Edit any_edit(const Model& model);

}  // namespace talus::edits::testing
