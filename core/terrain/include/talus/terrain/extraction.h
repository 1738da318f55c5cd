// From stacks to voxels (thesis 3.7), and which chunks are uniform. Pure; any thread may call.
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

/// The chunk `coord` of the region's level. Its 32 x 32 columns must lie inside stacks.region (asserted). It
/// is made in the memory of `memory`, whatever that holds: with that of chunks before (Chunk::take_layers)
/// only what is missing is allocated, and more where features change voxels or the boundary view cannot hold
/// all layers.
[[nodiscard]] Chunk extract_chunk(const World& world, const Stacks& stacks, ChunkCoord coord,
                                  Layers memory = {});

/// Ground of a level under this has water over it whatever its row: where level 0 has water the topmost voxel
/// of a coarse level is water, or few rivers would be left. In subvoxels of the level.
[[nodiscard]] std::int32_t wet_fx(const World& world, Lod lod);

/// What features put at the top of each column's rock, or into the floor of a cave that is open to the sky,
/// such as ore; kAir where they put nothing. z slowest, then x. It shows where no loose material lies.
[[nodiscard]] std::vector<MaterialId> exposed_overlays(const World& world, const Stacks& stacks);

/// What objects show from above: of each column of the stacks the material of their topmost voxel, kAir where
/// there is none, and the row at which it ends. z slowest, then x.
struct ObjectTops {
  std::vector<MaterialId> materials;
  std::vector<std::int32_t> rows;
};
[[nodiscard]] ObjectTops object_tops(const World& world, const Stacks& stacks);

/// Chunk rows [first, last] outside which every chunk over these 32 x 32 columns is uniform: `below` under
/// them, air above.
struct MixedRange {
  std::int32_t first = 0;
  std::int32_t last = 0;  // first - 1 where no chunk is mixed
  MaterialId below{};
};
[[nodiscard]] MixedRange mixed_range(const World& world, const Stacks& stacks, std::int32_t chunk_x,
                                     std::int32_t chunk_z);

/// The same for every column of a level, whatever the surface does. Costs nothing.
[[nodiscard]] MixedRange mixed_range(const World& world, Lod lod);

/// The material of a chunk that is uniform whatever the surface does: all below the lowest or above the
/// highest that this world can have. Costs nothing.
[[nodiscard]] std::optional<MaterialId> uniform_everywhere(const World& world, ChunkKey key);

/// The row of voxels of a level at and above which all is air.
[[nodiscard]] std::int64_t highest_row(const World& world, Lod lod);

/// Rows of base voxels between which everything but plain rock and air lies, at every level: below `low` all
/// is the first layer's material, at and above `high` all is air.
using talus::HeightRange;
[[nodiscard]] HeightRange height_range(const World& world);

/// One chunk alone, from scratch.
[[nodiscard]] Chunk generate_chunk(const World& world, ChunkKey key);

}  // namespace talus::terrain
