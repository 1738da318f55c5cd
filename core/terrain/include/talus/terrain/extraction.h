// From stacks to voxels (thesis 3.7), and the chunks that are uniform. Pure; thread-safe.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <talus/terrain/stacks.h>
#include <talus/terrain/world.h>
#include <talus/voxel/chunk.h>
#include <talus/voxel/coords.h>
#include <talus/voxel/material.h>

namespace talus::terrain {

/// The region whose stacks extract_chunk() needs for the chunks of `region`: one more column on every side at
/// level 0 of a world with secrets, whose chunks depend on the ground beside them; else `region`.
[[nodiscard]] Region region_of_stacks(const World& world, const Region& region);

/// Returns chunk `coord` of the region's level. Its region_of_stacks() must lie inside stacks.region
/// (asserted). Reuses `memory`, whatever it holds: with the layers of an earlier chunk (Chunk::take_layers)
/// only the difference is allocated, and more if features change voxels or the boundary view cannot hold all
/// layers.
[[nodiscard]] Chunk extract_chunk(const World& world, const Stacks& stacks, ChunkCoord coord,
                                  Layers memory = {});

/// Ground of a level below this height has water over it, whatever its row: if level 0 has water, the topmost
/// voxel of a coarse level is water; otherwise few rivers would be left. In subvoxels of the level.
[[nodiscard]] std::int32_t wet_fx(const World& world, Lod lod);

/// Returns, for each column, the material that features put at the top of the rock, or into the floor of a
/// cave that is open to the sky, such as ore; kAir if there is no such material. z slowest, then x. Visible
/// only without loose material on it.
[[nodiscard]] std::vector<MaterialId> exposed_overlays(const World& world, const Stacks& stacks);

/// Objects seen from above: for each column of the stacks the material of their topmost voxel, kAir if there
/// is no object, and the row at which that voxel ends. z slowest, then x.
struct ObjectTops {
  std::vector<MaterialId> materials;
  std::vector<std::int32_t> rows;
};
[[nodiscard]] ObjectTops object_tops(const World& world, const Stacks& stacks);

/// Outside chunk rows [first, last], every chunk over these 32 x 32 columns is uniform: `below` under them,
/// air above.
struct MixedRange {
  std::int32_t first = 0;
  std::int32_t last = 0;  // first - 1 if all chunks are uniform
  MaterialId below{};
};
[[nodiscard]] MixedRange mixed_range(const World& world, const Stacks& stacks, std::int32_t chunk_x,
                                     std::int32_t chunk_z);

/// The range that holds for every column of a level, whatever the surface. Cheap: reads no columns.
[[nodiscard]] MixedRange mixed_range(const World& world, Lod lod);

/// Returns the material of a chunk that is uniform whatever the surface: below the lowest or above the
/// highest that this world can have. Cheap: reads no columns.
[[nodiscard]] std::optional<MaterialId> uniform_everywhere(const World& world, ChunkKey key);

/// Returns the voxel row of a level at and above which everything is air.
[[nodiscard]] std::int64_t highest_row(const World& world, Lod lod);

/// The rows of base voxels that hold everything but plain rock and air, over all levels: below `low`
/// everything is the first layer's material, at and above `high` everything is air.
using talus::HeightRange;
[[nodiscard]] HeightRange height_range(const World& world);

/// Generates one chunk from scratch.
[[nodiscard]] Chunk generate_chunk(const World& world, ChunkKey key);

}  // namespace talus::terrain
