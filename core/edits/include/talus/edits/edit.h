// An edit as stored in the log: its changes, its conditions, and the bounds of both. Coordinates are base
// voxels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include <talus/voxel/chunk.h>
#include <talus/voxel/coords.h>

namespace talus::edits {

/// Bounds of one edit. A voxel that several operations or guards name counts once for each.
inline constexpr std::size_t kMaxVoxels = 65'536;
inline constexpr std::size_t kMaxChunks = 64;  // chunks of level 0
/// Maximum rows above and below the world's own rows that an edit may reach.
inline constexpr std::int64_t kRowMargin = 4'096;

/// Sets a voxel to `material`; as a guard, requires it.
struct VoxelWrite {
  VoxelPos voxel;
  MaterialId material{};
  bool operator==(const VoxelWrite&) const = default;
};

/// All voxels of a box, both corners included.
struct Fill {
  VoxelPos first;                      // the lowest corner
  VoxelPos last;                       // the highest
  std::optional<MaterialId> material;  // nullopt: as generated, which undoes edits
  std::optional<MaterialId> only;      // only voxels of this material change; nullopt: all
};

/// Number of voxels of the box, for any corners: 0 if a first coordinate exceeds the last; only a value above
/// kMaxVoxels if there are more.
[[nodiscard]] std::size_t volume(const Fill& fill);

/// A chunk's voxels, at any position: voxel (0, 0, 0) of `voxels` is placed at `origin`.
struct Paste {
  VoxelPos origin;
  Chunk voxels = Chunk::uniform(kAir);
  bool with_air = false;  // if false, air in the paste leaves voxels unchanged
};

/// If all guards hold, the operations are applied in this order, each on the result of the previous ones.
struct Edit {
  std::vector<VoxelWrite> guards;
  std::vector<VoxelWrite> writes;  // in order: the last write of a voxel counts
  std::vector<Fill> fills;         // in order
  std::optional<Paste> paste;
};

/// Number of voxels that the edit names, with repetitions, and all voxels of a paste, for any corners: the
/// amount that rates limit. If a fill has more than kMaxVoxels, only a value above kMaxVoxels.
[[nodiscard]] std::size_t named_voxels(const Edit& edit);

/// Both corners are included.
struct VoxelBox {
  VoxelPos first;
  VoxelPos last;
  bool operator==(const VoxelBox&) const = default;
};

/// The size of an edit, computed once, when the edit is admitted.
struct Extent {
  std::size_t voxels = 0;  // named_voxels()
  /// Chunks of level 0 that the edit may write or guards, in order, without duplicates; which ones it writes
  /// is known only when it is applied. Empty if touched_voxels() rejects the edit.
  std::vector<ChunkCoord> chunks{};
  std::optional<VoxelBox> loose{};         // settle_box(); nullopt if nothing may settle
  std::vector<ChunkCoord> loose_chunks{};  // chunks of `loose` that are not in `chunks`, in order
  /// chunks_beside(), where edits may reveal secrets.
  std::vector<ChunkCoord> beside_chunks{};
};

/// Cheap for any edit: visits no voxels of fills or pastes. `settles`: loose material may settle.
[[nodiscard]] Extent extent_of(const Edit& edit, bool settles);

/// The other chunks of the world with a voxel that shares a face with one of the edit or of `extent.loose`,
/// in order. At most as many as an edit may reach with its own. As cheap as extent_of().
[[nodiscard]] std::vector<ChunkCoord> chunks_beside(const Edit& edit, const Extent& extent);

/// Why an edit is rejected, in one line: the thing, the fault, and what is expected.
struct EditError {
  std::string message;
};

/// A chunk of level 0 and its voxels that an edit may write or guards, by ascending index, each once.
struct TouchedChunk {
  ChunkCoord chunk;
  std::vector<std::uint16_t> voxels;
};

/// The voxels whose base materials evaluate() needs, ordered by chunk coordinates; an error if the edit
/// leaves the world or exceeds kMaxVoxels or kMaxChunks. Cheap for any edit: volumes are checked before
/// voxels are visited, and it stops at the first chunk too many.
[[nodiscard]] tl::expected<std::vector<TouchedChunk>, EditError> touched_voxels(const Edit& edit);

/// Adds the voxels of `loose`, if any, to `touched`, which touched_voxels() returned. They are not limited.
[[nodiscard]] std::vector<TouchedChunk> with_settling(std::vector<TouchedChunk> touched,
                                                      const std::optional<VoxelBox>& loose);

/// Adds all voxels of the world that share a face with one of `touched`. They are not limited.
[[nodiscard]] std::vector<TouchedChunk> with_neighbours(std::vector<TouchedChunk> touched);

/// Edits that a world allows. Checked by the node that accepts an edit, never when applying: nodes may have
/// different lists.
struct EditRules {
  HeightRange rows;                       // of the generated world; edits may reach kRowMargin farther
  std::span<const MaterialId> materials;  // writable materials, by ascending id
};

/// Fails with the first part of `edit` that `rules` forbid. Does not check the bounds of touched_voxels():
/// call it first.
[[nodiscard]] tl::expected<void, EditError> check(const Edit& edit, const EditRules& rules);

}  // namespace talus::edits
