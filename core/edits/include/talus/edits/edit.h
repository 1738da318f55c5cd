// An edit as the log holds it: what shall change, under which conditions, and the bounds of both. Coordinates
// are base voxels.
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

/// Bounds of one edit. A voxel that two operations write, or one writes and a guard reads, counts twice.
inline constexpr std::size_t kMaxVoxels = 65'536;
inline constexpr std::size_t kMaxChunks = 64;  // of level 0
/// How far above and below the world's own rows an edit may reach.
inline constexpr std::int64_t kRowMargin = 4'096;

/// A voxel that shall be of `material`; as a guard, one that must be.
struct VoxelWrite {
  VoxelPos voxel;
  MaterialId material{};
  bool operator==(const VoxelWrite&) const = default;
};

/// Every voxel of a box, both corners included.
struct Fill {
  VoxelPos first;                      // the lowest corner
  VoxelPos last;                       // the highest
  std::optional<MaterialId> material;  // none: as generated, which undoes edits
  std::optional<MaterialId> only;      // voxels of other materials stay; none: any
};

/// Voxels of the box, whatever its corners: 0 where a first coordinate is greater than the last, beyond
/// kMaxVoxels only that they are more.
[[nodiscard]] std::size_t volume(const Fill& fill);

/// A chunk's voxels, at any place: voxel (0, 0, 0) of `voxels` comes to `origin`.
struct Paste {
  VoxelPos origin;
  Chunk voxels = Chunk::uniform(kAir);
  bool with_air = false;  // whether air is written too; if not, it leaves what is there
};

/// Where all guards hold, operations are done in this order, each on what those before it left.
struct Edit {
  std::vector<VoxelWrite> guards;
  std::vector<VoxelWrite> writes;  // in order: of two for one voxel the later counts
  std::vector<Fill> fills;         // in order
  std::optional<Paste> paste;
};

/// Voxels that the edit names, each as often as it does, and of a paste all, whatever its corners: what rates
/// count. Where a fill has more than kMaxVoxels only that they are more.
[[nodiscard]] std::size_t named_voxels(const Edit& edit);

/// Chunks of level 0 that hold those voxels, those of guards and writes counted once, and those of each fill
/// and of the paste again: what it costs to look their base up. At most kMaxChunks of each fill; of a place
/// beyond the world any number.
[[nodiscard]] std::size_t named_chunks(const Edit& edit);

/// The chunks of level 0 that the edit may write, and those of its guards, each once, in order: whether it
/// writes them is not known before it happens. `settles`: with those of settle_box(). None of an edit that
/// touched_voxels() refuses. Cheap: no voxel of a fill or paste is visited. REQUIRES: named_voxels() is at
/// most kMaxVoxels.
[[nodiscard]] std::vector<ChunkCoord> touched_chunks(const Edit& edit, bool settles = false);

/// Why an edit is refused, in one line: the thing, what is wrong, what would be right.
struct EditError {
  std::string message;
};

/// A chunk of level 0 and those of its voxels that an edit may write or guards, by rising index, each once.
struct TouchedChunk {
  ChunkCoord chunk;
  std::vector<std::uint16_t> voxels;
};

/// The voxels whose base materials evaluate() needs, by chunk, in the order of chunk coordinates; or an error
/// where the edit leaves the world or breaks kMaxVoxels or kMaxChunks. Cheap for any edit: volumes are
/// counted before anything is visited, and it stops at the first chunk too many. `settles`: with those of
/// settle_box(), which count to no bound.
[[nodiscard]] tl::expected<std::vector<TouchedChunk>, EditError> touched_voxels(const Edit& edit,
                                                                                bool settles = false);

/// What a world lets an edit write. The node that takes an edit asks this; applying never does, for lists of
/// nodes differ.
struct EditRules {
  HeightRange rows;                       // of the world as generated; edits reach kRowMargin farther
  std::span<const MaterialId> materials;  // which may be written, by rising id
};

/// The first thing in `edit` that `rules` forbid, or nothing. Says nothing of touched_voxels()' bounds: call
/// that first.
[[nodiscard]] tl::expected<void, EditError> check(const Edit& edit, const EditRules& rules);

}  // namespace talus::edits
