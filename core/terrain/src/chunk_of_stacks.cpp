// Stacks -> voxels: boundaries become voxel rows (thesis 3.7), a chunk is its slab of them.
#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include <talus/terrain/boundary_row.h>
#include <talus/terrain/stacks.h>

#include "inserts.h"
#include "kernels/columns.h"
#include "ore_inserts.h"

namespace talus::terrain {
namespace {

using Rows = std::array<std::int32_t, kChunkArea>;

// No surface and no sea lies farther from y = 0, and differences with it fit 32 bits.
constexpr std::int32_t kFarRow = 1 << 24;

// The boundary rows of 32 x 32 columns, plane by plane, in the region's level.
class TileRows {
 public:
  TileRows(const World& world, const Stacks& stacks, std::int32_t chunk_x, std::int32_t chunk_z)
      : stacks_{stacks},
        kernels_{column_kernels(instruction_set())},
        x_{static_cast<int>(std::int64_t{chunk_x} * kChunkSize - stacks.region.x)},
        z_{static_cast<int>(std::int64_t{chunk_z} * kChunkSize - stacks.region.z)},
        coarse_{stacks.region.lod.value() > 0} {
    assert(x_ >= 0 && z_ >= 0 && x_ + kChunkSize <= stacks.region.width &&
           z_ + kChunkSize <= stacks.region.depth);
    if (coarse_) find_crowns();
    if (world.sea_fx()) sea_row_ = boundary_row(*world.sea_fx() >> stacks.region.lod.value());
  }

  [[nodiscard]] std::size_t planes() const { return stacks_.tops.size(); }
  [[nodiscard]] MaterialId material(std::size_t plane) const { return stacks_.materials[plane]; }

  /// Boundary rows of a plane.
  void read(std::size_t plane, Rows& rows) const {
    for (int z = 0; z < kChunkSize; ++z) {
      const std::int32_t* tops = line(plane, z);
      for (int x = 0; x < kChunkSize; ++x) rows[column_index(x, z)] = boundary_row(tops[x]);
    }
    if (!coarse_) return;
    // Far hills keep their grass: the topmost solid voxel takes the material at the top of the stack, even
    // where that is too thin to reach the voxel's centre.
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i] = plane < crown_[i] ? std::min(rows[i], ground_[i] - 1) : ground_[i];
    }
  }

  /// The boundary rows of a field over the stacks, counted from `floor_row` and cut to a chunk.
  void cut(const Field& field, std::int32_t floor_row, ChunkPlane& rows) const {
    for (int z = 0; z < kChunkSize; ++z) {
      kernels_.cut(field.row(z_ + z).data() + x_, kChunkSize, floor_row, rows.data() + column_index(0, z));
    }
  }
  /// The same of a plane, with the crowns of coarse levels.
  void cut(std::size_t plane, std::int32_t floor_row, ChunkPlane& rows) const {
    if (!coarse_) return cut(stacks_.tops[plane], floor_row, rows);
    Rows whole{};
    read(plane, whole);
    std::transform(whole.begin(), whole.end(), rows.begin(),
                   [&](std::int32_t row) { return cut(row, floor_row); });
  }
  static std::uint8_t cut(std::int32_t row, std::int32_t floor_row) {
    return static_cast<std::uint8_t>(std::clamp(row - floor_row, 0, kChunkSize));
  }

  /// Water stands from the ground up to here; far below all where there is none.
  [[nodiscard]] std::int32_t sea_row() const { return sea_row_; }

  /// The lowest row of a cave; far above all where there is none.
  [[nodiscard]] std::int32_t lowest_cave() const {
    std::int32_t lowest = kFarRow;
    if (stacks_.caves.none()) return lowest;
    for (int z = 0; z < kChunkSize; ++z) {
      for (int x = 0; x < kChunkSize; ++x) {
        if (!stacks_.caves.has(x_ + x, z_ + z)) continue;
        lowest = std::min(lowest, boundary_row(stacks_.caves.floor.at(x_ + x, z_ + z)));
      }
    }
    return lowest;
  }

 private:
  void find_crowns() {
    read_ground();
    for (std::size_t plane = 1; plane < planes(); ++plane) {
      for (int z = 0; z < kChunkSize; ++z) {
        const std::int32_t* tops = stacks_.tops[plane].row(z_ + z).data() + x_;
        const std::int32_t* below = stacks_.tops[plane - 1].row(z_ + z).data() + x_;
        for (int x = 0; x < kChunkSize; ++x) {
          if (tops[x] > below[x]) crown_[column_index(x, z)] = plane;
        }
      }
    }
  }

  void read_ground() {
    for (int z = 0; z < kChunkSize; ++z) {
      const std::int32_t* tops = stacks_.tops.back().row(z_ + z).data() + x_;
      for (int x = 0; x < kChunkSize; ++x) ground_[column_index(x, z)] = boundary_row(tops[x]);
    }
  }

  [[nodiscard]] const std::int32_t* line(std::size_t plane, int z) const {
    return stacks_.tops[plane].row(z_ + z).data() + x_;
  }

  const Stacks& stacks_;
  const ColumnKernels& kernels_;
  int x_;
  int z_;
  bool coarse_;
  std::int32_t sea_row_ = -kFarRow;
  std::array<std::size_t, kChunkArea> crown_{};  // the plane of the material at the top of each stack
  Rows ground_{};
};

}  // namespace

Chunk extract_chunk(const World& world, const Stacks& stacks, ChunkCoord coord) {
  const TileRows tile{world, stacks, coord.x, coord.z};
  const auto floor_row = static_cast<std::int32_t>(
      std::clamp<std::int64_t>(std::int64_t{coord.y} * kChunkSize, -kFarRow, kFarRow));
  Layers layers;
  ChunkPlane below{};
  const auto add_plane = [&](MaterialId material, const ChunkPlane& plane) {
    if (plane == below) return;
    layers.materials.push_back(material);
    layers.tops.insert(layers.tops.end(), plane.begin(), plane.end());
    below = plane;
  };
  ChunkPlane rows;
  ChunkPlane rock;
  const std::size_t top_of_rock = tile.planes() - 1 - world.loose().size();
  for (std::size_t plane = 0; plane < tile.planes(); ++plane) {
    tile.cut(plane, floor_row, rows);
    add_plane(tile.material(plane), rows);
    if (plane == top_of_rock) rock = rows;
  }
  const std::uint8_t sea = TileRows::cut(tile.sea_row(), floor_row);
  for (std::uint8_t& row : rows) row = std::max(row, sea);
  add_plane(kWater, rows);
  layers.materials.push_back(kAir);

  std::vector<Insert> inserts;
  if (!world.spec().veins.empty()) inserts = ore_inserts(world, {coord, stacks.region.lod}, rock);
  if (!stacks.caves.none()) {
    Insert& air = inserts.emplace_back(Insert{kAir, {}, {}});
    tile.cut(stacks.caves.floor, floor_row, air.from);
    tile.cut(stacks.caves.roof, floor_row, air.to);
  }
  return chunk_with(std::move(layers), inserts);
}

MixedRange mixed_range(const World& world, const Stacks& stacks, std::int32_t chunk_x, std::int32_t chunk_z) {
  const TileRows tile{world, stacks, chunk_x, chunk_z};
  Rows rows{};
  tile.read(0, rows);
  const std::int32_t lowest = std::min({*std::min_element(rows.begin(), rows.end()), tile.lowest_cave(),
                                        lowest_ore_row(world, stacks.region.lod)});
  tile.read(tile.planes() - 1, rows);
  const std::int32_t highest = std::max(*std::max_element(rows.begin(), rows.end()), tile.sea_row());
  const auto chunk_row = [](std::int32_t row) {
    return static_cast<std::int32_t>(floor_div(row, kChunkSize));
  };
  const std::int32_t first = chunk_row(lowest);
  return {first, std::max(first - 1, chunk_row(highest - 1)), tile.material(0)};
}

std::int64_t highest_row(const World& world, Lod lod) {
  const int shift = lod.value();
  return std::max(boundary_row((world.highest_fx() >> shift) + world.rise_fx()),
                  world.sea_fx() ? boundary_row(*world.sea_fx() >> shift) : 0);
}

HeightRange height_range(const World& world) {
  HeightRange range;
  for (int level = 0; level <= Lod::kMax; ++level) {
    range.high = std::max(range.high, highest_row(world, Lod::of(level)) << level);
  }
  return range;
}

MixedRange mixed_range(const World& world, Lod lod) {
  // At coarse levels the topmost solid voxel may lie just below y = 0.
  const std::int64_t low = lod.value() == 0 ? 0 : -1;
  const std::int64_t first = floor_div(low, kChunkSize);
  const std::int64_t last = floor_div(highest_row(world, lod) - 1, kChunkSize);
  return {static_cast<std::int32_t>(first), static_cast<std::int32_t>(std::max(first - 1, last)),
          world.strata().front().material};
}

std::optional<MaterialId> uniform_everywhere(const World& world, ChunkKey key) {
  const MixedRange rows = mixed_range(world, key.lod);
  if (key.coord.y < rows.first) return rows.below;
  if (key.coord.y > rows.last) return kAir;
  return std::nullopt;
}

Chunk generate_chunk(const World& world, ChunkKey key) {
  if (const auto material = uniform_everywhere(world, key)) return Chunk::uniform(*material);
  const VoxelPos origin = chunk_origin(key.coord);
  const Region tile{origin.x, origin.z, kChunkSize, kChunkSize, key.lod};
  return extract_chunk(world, generate_stacks(world, tile), key.coord);
}

}  // namespace talus::terrain
