#include "ore_inserts.h"

#include <algorithm>
#include <limits>

#include <talus/terrain/boundary_row.h>
#include <talus/terrain/stacks.h>

#include "ore_bodies.h"

namespace talus::terrain {
namespace {

// The rows of a lobe in a chunk's columns. Whether there are any.
bool cut(const OreLobe& lobe, ChunkKey key, const ChunkPlane& rock, Insert& insert) {
  const int shift = key.lod.value();
  const VoxelPos origin = chunk_origin(key.coord);
  const std::int64_t step = std::int64_t{1} << shift;
  const auto first = [&](std::int64_t middle_fx, std::int64_t from) {
    const std::int64_t column = floor_div(middle_fx - lobe.reach_fx, step * kSubvoxels) - from;
    return static_cast<int>(std::clamp<std::int64_t>(column, 0, kChunkSize));
  };
  const auto last = [&](std::int64_t middle_fx, std::int64_t from) {
    const std::int64_t column = floor_div(middle_fx + lobe.reach_fx, step * kSubvoxels) - from;
    return static_cast<int>(std::clamp<std::int64_t>(column, -1, kChunkSize - 1));
  };
  bool any = false;
  for (int z = first(lobe.z_fx, origin.z); z <= last(lobe.z_fx, origin.z); ++z) {
    for (int x = first(lobe.x_fx, origin.x); x <= last(lobe.x_fx, origin.x); ++x) {
      const auto span = lobe.at((origin.x + x) * step, (origin.z + z) * step);
      if (!span) continue;
      const std::size_t column = column_index(x, z);
      const auto row = [&](std::int32_t height_fx) {
        return static_cast<std::uint8_t>(
            std::clamp<std::int64_t>(boundary_row(height_fx >> shift) - origin.y, 0, rock[column]));
      };
      insert.from[column] = row(span->from_fx);
      insert.to[column] = row(span->to_fx);
      any = any || insert.from[column] < insert.to[column];
    }
  }
  return any;
}

// Adds a lobe to what its ore has already, where both are one run in every column.
bool join(const Insert& lobe, Insert& insert) {
  for (std::size_t i = 0; i < kChunkArea; ++i) {
    const bool both = lobe.from[i] < lobe.to[i] && insert.from[i] < insert.to[i];
    if (both && (lobe.from[i] > insert.to[i] || lobe.to[i] < insert.from[i])) return false;
  }
  for (std::size_t i = 0; i < kChunkArea; ++i) {
    if (lobe.from[i] >= lobe.to[i]) continue;
    const bool free = insert.from[i] >= insert.to[i];
    insert.from[i] = free ? lobe.from[i] : std::min(insert.from[i], lobe.from[i]);
    insert.to[i] = free ? lobe.to[i] : std::max(insert.to[i], lobe.to[i]);
  }
  return true;
}

OreBox box_of(ChunkKey key) {
  const int shift = key.lod.value();
  const VoxelPos origin = chunk_origin(key.coord);
  const std::int64_t step = std::int64_t{1} << shift;
  constexpr std::int64_t kLast = kChunkSize - 1;
  return {origin.x * step,
          (origin.x + kLast) * step + 1,
          origin.z * step,
          (origin.z + kLast) * step + 1,
          origin.y * step * kSubvoxels,
          (origin.y + kChunkSize) * step * kSubvoxels};
}

}  // namespace

std::vector<Insert> ore_inserts(const World& world, ChunkKey key, const ChunkPlane& rock) {
  std::vector<Insert> inserts;
  if (*std::max_element(rock.begin(), rock.end()) == 0) return inserts;
  std::vector<OreLobe> lobes;
  for (std::size_t i = world.spec().veins.size(); i-- > 0;) {
    const OreKind kind = ore_kind(world.spec(), i);
    if (!kind.shows_at(key.lod)) continue;
    lobes.clear();
    add_lobes(kind, box_of(key), lobes);
    const std::size_t first = inserts.size();
    for (const OreLobe& lobe : lobes) {
      Insert alone{kind.material, {}, {}};
      if (!cut(lobe, key, rock, alone)) continue;
      const auto joined = std::any_of(inserts.begin() + static_cast<std::ptrdiff_t>(first), inserts.end(),
                                      [&](Insert& insert) { return join(alone, insert); });
      if (!joined) inserts.push_back(alone);
    }
  }
  return inserts;
}

std::int32_t lowest_ore_row(const World& world, Lod lod) {
  std::int32_t lowest = std::numeric_limits<std::int32_t>::max();
  for (std::size_t i = 0; i < world.spec().veins.size(); ++i) {
    const OreKind kind = ore_kind(world.spec(), i);
    if (kind.shows_at(lod)) lowest = std::min(lowest, boundary_row(kind.low_fx >> lod.value()));
  }
  return lowest;
}

std::vector<MaterialId> surface_ore(const World& world, const Stacks& stacks) {
  const Region& region = stacks.region;
  const Field& rock = stacks.tops[stacks.tops.size() - 1 - world.loose().size()];
  std::vector<MaterialId> ore(region.columns(), kAir);
  const int shift = region.lod.value();
  const std::int64_t step = std::int64_t{1} << shift;
  const auto [lowest, highest] = std::minmax_element(rock.values.begin(), rock.values.end());
  const OreBox box{region.x * step,
                   (region.x + region.width - 1) * step + 1,
                   region.z * step,
                   (region.z + region.depth - 1) * step + 1,
                   (std::int64_t{*lowest} - kSubvoxels) * step,
                   (std::int64_t{*highest} + 1) * step};
  std::vector<OreLobe> lobes;
  for (std::size_t i = world.spec().veins.size(); i-- > 0;) {
    const OreKind kind = ore_kind(world.spec(), i);
    if (!kind.shows_at(region.lod)) continue;
    lobes.clear();
    add_lobes(kind, box, lobes);
    for (const OreLobe& lobe : lobes) {
      const auto range = [&](std::int64_t middle_fx, std::int64_t from, int count) {
        const std::int64_t edge = step * kSubvoxels;
        return std::pair{static_cast<int>(std::clamp<std::int64_t>(
                             floor_div(middle_fx - lobe.reach_fx, edge) - from, 0, count)),
                         static_cast<int>(std::clamp<std::int64_t>(
                             floor_div(middle_fx + lobe.reach_fx, edge) + 1 - from, 0, count))};
      };
      const auto [west, east] = range(lobe.x_fx, region.x, region.width);
      const auto [north, south] = range(lobe.z_fx, region.z, region.depth);
      for (int z = north; z < south; ++z) {
        for (int x = west; x < east; ++x) {
          const auto span = lobe.at((region.x + x) * step, (region.z + z) * step);
          // The voxel under the surface of the rock, or under the floor of an open cave, at its centre.
          const std::int32_t row = boundary_row(std::min(rock.at(x, z), stacks.ground_fx(x, z))) - 1;
          if (span && row >= boundary_row(span->from_fx >> shift) &&
              row < boundary_row(span->to_fx >> shift)) {
            ore[static_cast<std::size_t>(z) * static_cast<std::size_t>(region.width) +
                static_cast<std::size_t>(x)] = kind.material;
          }
        }
      }
    }
  }
  return ore;
}

}  // namespace talus::terrain
