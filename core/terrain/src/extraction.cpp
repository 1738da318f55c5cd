// Stacks -> voxels: boundaries become voxel rows (thesis 3.7), a chunk is its slab of them.
#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include <talus/terrain/boundary_row.h>
#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>

#include "feature.h"
#include "features/object_models.h"
#include "kernels/chunk_planes.h"
#include "kernels/columns.h"
#include "overlay.h"

namespace talus::terrain {
namespace {

using Rows = std::array<std::int32_t, kChunkArea>;

// Farther from y = 0 than any surface or sea, yet differences with it fit 32 bits.
constexpr std::int32_t kFarRow = 1 << 24;

// The boundary rows of 32 x 32 columns, plane by plane, in the region's level.
class TileRows {
 public:
  TileRows(const World& world, const Stacks& stacks, std::int32_t chunk_x, std::int32_t chunk_z)
      : stacks_{stacks},
        kernels_{column_kernels(instruction_set())},
        x_{static_cast<int>(std::int64_t{chunk_x} * kChunkSize - stacks.region.x)},
        z_{static_cast<int>(std::int64_t{chunk_z} * kChunkSize - stacks.region.z)},
        coarse_{stacks.region.lod.value() > 0},
        wet_fx_{wet_fx(world, stacks.region.lod)} {
    assert(x_ >= 0 && z_ >= 0 && x_ + kChunkSize <= stacks.region.width &&
           z_ + kChunkSize <= stacks.region.depth);
    const int level = stacks.region.lod.value();
    if (world.sea_fx()) sea_row_ = boundary_row(*world.sea_fx() >> level);
    if (coarse_) find_caps(world.shown_depth_fx(stacks.region.lod));
  }

  [[nodiscard]] std::size_t planes() const { return stacks_.tops.size(); }
  [[nodiscard]] MaterialId material(std::size_t plane) const { return stacks_.materials[plane]; }
  /// Row z of the looks of the tile's columns, by rules `rules`.
  [[nodiscard]] const std::uint8_t* looks(std::size_t rules, int z) const {
    return stacks_.looks[rules].row(z_ + z).data() + x_;
  }
  /// Stride between rows of looks.
  [[nodiscard]] std::size_t width() const { return static_cast<std::size_t>(stacks_.region.width); }

  [[nodiscard]] std::int32_t lowest(std::size_t plane) const {
    return extreme(plane, [](std::int32_t a, std::int32_t b) { return std::min(a, b); });
  }
  [[nodiscard]] std::int32_t highest(std::size_t plane) const {
    return extreme(plane, [](std::int32_t a, std::int32_t b) { return std::max(a, b); });
  }

  /// The boundary rows of a field over the stacks, relative to `floor_row` and clamped to a chunk.
  void cut(const Field& field, std::int32_t floor_row, ChunkPlane& rows) const {
    kernels_.cut(field.row(z_).data() + x_, static_cast<std::size_t>(field.width), floor_row, rows.data());
  }
  /// The boundary rows of a plane, with the surface caps of coarse levels.
  void cut(std::size_t plane, std::int32_t floor_row, ChunkPlane& rows) const {
    if (!coarse_) return cut(stacks_.tops[plane], floor_row, rows);
    const Rows whole = read(plane);
    std::transform(whole.begin(), whole.end(), rows.begin(),
                   [&](std::int32_t row) { return cut(row, floor_row); });
  }
  static std::uint8_t cut(std::int32_t row, std::int32_t floor_row) {
    return static_cast<std::uint8_t>(std::clamp(row - floor_row, 0, kChunkSize));
  }

  /// The top of the sea's water; far below everything if there is no sea.
  [[nodiscard]] std::int32_t sea_row() const { return sea_row_; }

  /// The lowest row of a cave; far above everything if there is no cave.
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
  /// The boundary row of the column of a plane that `pick` selects.
  template <typename Pick>
  [[nodiscard]] std::int32_t extreme(std::size_t plane, Pick&& pick) const {
    if (coarse_) {
      const Rows rows = read(plane);
      return std::accumulate(rows.begin(), rows.end(), rows[0], pick);
    }
    std::int32_t kept_fx = line(plane, 0)[0];
    for (int z = 0; z < kChunkSize; ++z) {
      const std::int32_t* tops = line(plane, z);
      for (int x = 0; x < kChunkSize; ++x) kept_fx = pick(kept_fx, tops[x]);
    }
    return boundary_row(kept_fx);
  }

  /// Boundary rows of a plane of a coarse level. To keep far hills green, the topmost solid voxel takes the
  /// material near the top of the stack, even if its layer is too thin to reach the voxel's centre.
  [[nodiscard]] Rows read(std::size_t plane) const {
    Rows rows;
    for (int z = 0; z < kChunkSize; ++z) {
      const std::int32_t* tops = line(plane, z);
      for (int x = 0; x < kChunkSize; ++x) {
        const std::size_t i = column_index(x, z);
        rows[i] = plane < cap_plane_[i] ? std::min(boundary_row(tops[x]), ground_[i] - 1) : ground_[i];
      }
    }
    return rows;
  }

  void find_caps(std::int32_t depth_fx) {
    read_ground();
    for (std::size_t plane = 1; plane < planes(); ++plane) {
      for (int z = 0; z < kChunkSize; ++z) {
        const std::int32_t* const tops = line(planes() - 1, z);
        const std::int32_t* const below = line(plane - 1, z);
        for (int x = 0; x < kChunkSize; ++x) {
          if (below[x] < tops[x] - depth_fx) cap_plane_[column_index(x, z)] = plane;
        }
      }
    }
  }

  void read_ground() {
    for (int z = 0; z < kChunkSize; ++z) {
      const std::int32_t* tops = stacks_.tops.back().row(z_ + z).data() + x_;
      for (int x = 0; x < kChunkSize; ++x) {
        const std::int32_t most = tops[x] < wet_fx_ ? sea_row_ - 1 : kFarRow;
        ground_[column_index(x, z)] = std::min(boundary_row(tops[x]), most);
      }
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
  std::int32_t wet_fx_;
  std::int32_t sea_row_ = -kFarRow;
  std::array<std::size_t, kChunkArea> cap_plane_{};  // the plane shown by the topmost solid voxel
  Rows ground_{};
};

// Builds the layers of a chunk, bottom up. Planes are ordered, so if two have equal cuts, so do all between
// them, which can be skipped: in most chunks that is more than half.
class LayerPicker {
 public:
  LayerPicker(const World& world, const TileRows& tile, std::int32_t floor_row, Layers memory)
      : world_{world}, tile_{tile}, floor_row_{floor_row}, layers_{std::move(memory)} {
    layers_.materials.clear();
    layers_.tops.clear();
  }

  /// Adds all planes and stores the cut of the last in `top`.
  void add_planes(ChunkPlane& top) {
    const std::size_t last = tile_.planes() - 1;
    ChunkPlane bottom;
    tile_.cut(0, floor_row_, bottom);
    add(tile_.material(0), bottom);
    tile_.cut(last, floor_row_, top);
    add_between(0, bottom, last, top);
    add(tile_.material(last), top);
  }
  /// Adds the plane unless it equals the plane before in all columns.
  void add(MaterialId material, const ChunkPlane& plane) {
    if (std::equal(plane.begin(), plane.end(), below())) return;
    const World::ShownBy* const shown = world_.shown_by(material);
    if (shown == nullptr || material == kWater) return push(material, plane);
    add_shown(*shown, plane);
  }
  /// Adds the sea's plane, whose topmost voxel may show another material, such as ice.
  void add_water(const ChunkPlane& plane, bool shows_top) {
    const World::ShownBy* const shown = world_.shown_by(kWater);
    if (shown == nullptr || !shows_top || std::equal(plane.begin(), plane.end(), below())) {
      return add(kWater, plane);
    }
    ChunkPlane under;
    const std::uint8_t* const ground = below();
    std::transform(plane.begin(), plane.end(), ground, under.begin(), [](std::uint8_t top, std::uint8_t low) {
      return top > low ? static_cast<std::uint8_t>(top - 1) : top;
    });
    add(kWater, under);
    if (!std::equal(plane.begin(), plane.end(), below())) add_shown(*shown, plane);
  }
  [[nodiscard]] Layers take() {
    layers_.materials.push_back(kAir);
    return std::move(layers_);
  }

 private:
  void add_between(std::size_t low, const ChunkPlane& low_rows, std::size_t high,
                   const ChunkPlane& high_rows) {
    if (high - low < 2 || low_rows == high_rows) return;
    const std::size_t middle = (low + high) / 2;
    ChunkPlane rows;
    tile_.cut(middle, floor_row_, rows);
    add_between(low, low_rows, middle, rows);
    add(tile_.material(middle), rows);
    add_between(middle, rows, high, high_rows);
  }

  [[nodiscard]] const std::uint8_t* below() const {
    static constexpr ChunkPlane kFloor{};
    return layers_.tops.empty() ? kFloor.data() : layers_.tops.data() + layers_.tops.size() - kChunkArea;
  }
  void push(MaterialId material, const ChunkPlane& plane) {
    layers_.materials.push_back(material);
    layers_.tops.insert(layers_.tops.end(), plane.begin(), plane.end());
  }

  /// Adds a layer for each shown material. Its plane equals `plane` in columns that show it or an earlier
  /// one, and the layer below in the others.
  void add_shown(const World::ShownBy& shown, const ChunkPlane& plane) {
    const std::uint64_t present = looks_in_tile(shown.looks);
    std::array<MaterialId, kMaxLooks + 1> found{};
    std::size_t count = 0;
    for (std::uint64_t looks = present; looks != 0; looks &= looks - 1) {
      const MaterialId material = shown.by_look[static_cast<std::size_t>(std::countr_zero(looks))];
      const std::span<const MaterialId> before{found.data(), count};
      if (std::find(before.begin(), before.end(), material) == before.end()) {
        found[count++] = material;
      }
    }
    const std::span<MaterialId> materials{found.data(), count};
    std::sort(materials.begin(), materials.end());
    for (std::size_t m = 0; m + 1 < materials.size(); ++m) {
      ChunkPlane rows;
      std::copy_n(below(), kChunkArea, rows.begin());
      for (std::uint64_t looks = present; looks != 0; looks &= looks - 1) {
        const int look = std::countr_zero(looks);
        if (shown.by_look[static_cast<std::size_t>(look)] != materials[m]) continue;
        kernels_.raise_where(tile_.looks(shown.looks, 0), tile_.width(), static_cast<std::uint8_t>(look),
                             plane.data(), rows.data());
      }
      if (!std::equal(rows.begin(), rows.end(), below())) push(materials[m], rows);
    }
    if (!std::equal(plane.begin(), plane.end(), below())) push(materials.back(), plane);
  }

  /// Bit k is set if a column of the tile has look k.
  [[nodiscard]] std::uint64_t looks_in_tile(std::size_t rules) {
    for (const TileLooks& known : present_) {
      if (known.looks != 0 && known.rules == rules) return known.looks;
    }
    std::uint64_t looks = 0;
    for (int z = 0; z < kChunkSize; ++z) {
      const std::uint8_t* const row = tile_.looks(rules, z);
      unsigned others = 0;  // nonzero if the row has several looks; most rows have one
      for (int x = 1; x < kChunkSize; ++x) others |= row[x] ^ unsigned { row[0] };
      looks |= std::uint64_t{1} << row[0];
      if (others == 0) continue;
      for (int x = 1; x < kChunkSize; ++x) looks |= std::uint64_t{1} << row[x];
    }
    present_[next_present_++ % present_.size()] = {rules, looks};
    return looks;
  }

  struct TileLooks {
    std::size_t rules = 0;
    std::uint64_t looks = 0;
  };

  const World& world_;
  const TileRows& tile_;
  const ChunkPlaneKernels& kernels_ = chunk_plane_kernels(instruction_set());
  std::int32_t floor_row_;
  Layers layers_;
  std::array<TileLooks, 8> present_{};  // a cache of the last queries
  std::size_t next_present_ = 0;
};

class ExtractedSite final : public ChunkSite {
 public:
  ExtractedSite(const World& world, const Stacks& stacks, const TileRows& tile, ChunkCoord coord,
                std::int32_t floor_row)
      : ChunkSite{world, stacks, coord}, tile_{tile}, floor_row_{floor_row} {}

  void cut(const Field& field, ChunkPlane& rows) const override { tile_.cut(field, floor_row_, rows); }
  [[nodiscard]] const ChunkPlane& rock() const override {
    if (!has_rock_) tile_.cut(tile_.planes() - 1 - stacks().loose_planes, floor_row_, rock_);
    has_rock_ = true;
    return rock_;
  }

 private:
  const TileRows& tile_;
  std::int32_t floor_row_;
  mutable bool has_rock_ = false;
  mutable ChunkPlane rock_;
};

const Field* survey_of(const Stacks& stacks, std::size_t feature) {
  const bool kept = feature < stacks.surveys.size() && !stacks.surveys[feature].values.empty();
  return kept ? &stacks.surveys[feature] : nullptr;
}

// The rows that overlays rise above the ground, without objects unless `objects` is true.
int above_ground(const World& world, Lod lod, bool objects) {
  int rows = 0;
  for (const auto& feature : world.features()) {
    if (objects || !feature->stands()) rows = std::max(rows, feature->overlay_rows(lod).above_ground);
  }
  return rows;
}

// The top row of the highest object that may reach over a tile, whichever tile its foot is in.
std::int64_t highest_object_row(const World& world, const Stacks& stacks, std::int32_t chunk_x,
                                std::int32_t chunk_z) {
  std::int64_t highest = std::numeric_limits<std::int32_t>::min();
  if (stacks.objects.empty()) return highest;
  const int level = stacks.region.lod.value();
  const int rows = above_ground(world, Lod{}, true);
  // At least what formulas reach, whatever the world's kinds do: golden.txt hashes all rows of a tile.
  int reach = kFormulaReach;
  for (const auto& feature : world.features()) {
    if (feature->stands()) reach = std::max(reach, feature->halo(Lod{}));
  }
  const auto apart = [&](std::int64_t foot, std::int32_t chunk) {
    const std::int64_t from = std::int64_t{chunk} * kChunkSize << level;
    const std::int64_t to = (std::int64_t{chunk} + 1) * kChunkSize << level;
    return foot + reach < from || foot - reach >= to;
  };
  for (const PlacedObject& object : stacks.objects) {
    if (apart(object.x, chunk_x) || apart(object.z, chunk_z)) continue;
    highest = std::max(highest, ((object.y + rows) >> level) + 1);
  }
  return highest;
}

// The union over all features.
OverlayRows overlay_rows(const World& world, Lod lod) {
  OverlayRows all;
  for (const auto& feature : world.features()) {
    const OverlayRows rows = feature->overlay_rows(lod);
    all.lowest = std::min(all.lowest, rows.lowest);
    all.above_ground = std::max(all.above_ground, rows.above_ground);
  }
  return all;
}

}  // namespace

ChunkSite::ChunkSite(const World& world, const Stacks& stacks, ChunkCoord coord)
    : world_{world},
      stacks_{stacks},
      key_{coord, stacks.region.lod},
      x_{static_cast<int>(std::int64_t{coord.x} * kChunkSize - stacks.region.x)},
      z_{static_cast<int>(std::int64_t{coord.z} * kChunkSize - stacks.region.z)} {}

Region region_of_stacks(const World& world, const Region& region) {
  return world.has_secrets() && region.lod == Lod{} ? region.expanded(1) : region;
}

Chunk extract_chunk(const World& world, const Stacks& stacks, ChunkCoord coord, Layers memory) {
  const TileRows tile{world, stacks, coord.x, coord.z};
  const auto floor_row = static_cast<std::int32_t>(
      std::clamp<std::int64_t>(std::int64_t{coord.y} * kChunkSize, -kFarRow, kFarRow));
  LayerPicker layers{world, tile, floor_row, std::move(memory)};
  ChunkPlane rows;
  layers.add_planes(rows);
  const std::uint8_t sea = TileRows::cut(tile.sea_row(), floor_row);
  for (std::uint8_t& row : rows) row = std::max(row, sea);
  const std::int64_t sea_above = std::int64_t{tile.sea_row()} - floor_row;
  layers.add_water(rows, sea_above > 0 && sea_above <= kChunkSize);

  std::vector<Overlay> overlays;
  if (!world.features().empty()) {
    const ExtractedSite site{world, stacks, tile, coord, floor_row};
    for (std::size_t i = 0; i < world.features().size(); ++i) {
      world.features()[i]->add_overlays(site, survey_of(stacks, i), overlays);
    }
  }
  Chunk chunk = chunk_with(layers.take(), overlays);
  if (stacks.objects.empty()) return chunk;
  std::vector<Override> overrides;
  const ExtractedSite site{world, stacks, tile, coord, floor_row};
  for (const auto& feature : world.features()) feature->add_overrides(site, overrides);
  return overrides.empty() ? std::move(chunk) : chunk.with_overrides(overrides);
}

std::int32_t wet_fx(const World& world, Lod lod) {
  const bool widens = world.sea_fx() && world.spec().surface.regions && lod.value() > 0;
  return widens ? (*world.sea_fx() - kSubvoxels / 2) >> lod.value()
                : std::numeric_limits<std::int32_t>::min();
}

ObjectTops object_tops(const World& world, const Stacks& stacks) {
  ObjectTops tops{
      std::vector<MaterialId>(stacks.region.columns(), kAir),
      std::vector<std::int32_t>(stacks.region.columns(), std::numeric_limits<std::int32_t>::min())};
  for (const auto& feature : world.features()) feature->add_tops(stacks, tops.materials, tops.rows);
  return tops;
}

std::vector<MaterialId> exposed_overlays(const World& world, const Stacks& stacks) {
  std::vector<MaterialId> exposed(stacks.region.columns(), kAir);
  for (std::size_t i = 0; i < world.features().size(); ++i) {
    world.features()[i]->add_exposed(stacks, survey_of(stacks, i), exposed);
  }
  return exposed;
}

MixedRange mixed_range(const World& world, const Stacks& stacks, std::int32_t chunk_x, std::int32_t chunk_z) {
  const TileRows tile{world, stacks, chunk_x, chunk_z};
  const OverlayRows overlays = overlay_rows(world, stacks.region.lod);
  const std::int64_t lowest = std::min<std::int64_t>({tile.lowest(0), tile.lowest_cave(), overlays.lowest});
  const std::int64_t highest =
      std::max<std::int64_t>(std::max(tile.highest(tile.planes() - 1), tile.sea_row()) +
                                 above_ground(world, stacks.region.lod, false),
                             highest_object_row(world, stacks, chunk_x, chunk_z));
  const auto chunk_row = [](std::int64_t row) {
    return static_cast<std::int32_t>(floor_div(row, kChunkSize));
  };
  const std::int32_t first = chunk_row(lowest);
  return {first, std::max(first - 1, chunk_row(highest - 1)), tile.material(0)};
}

std::int64_t highest_row(const World& world, Lod lod) {
  const int shift = lod.value();
  const std::int32_t ground_or_sea = std::max(boundary_row((world.highest_fx() >> shift) + world.rise_fx()),
                                              world.sea_fx() ? boundary_row(*world.sea_fx() >> shift) : 0);
  return ground_or_sea + overlay_rows(world, lod).above_ground;
}

HeightRange height_range(const World& world) {
  HeightRange range;
  for (int level = 0; level <= Lod::kMax; ++level) {
    const Lod lod = Lod::of(level);
    range.high = std::max(range.high, highest_row(world, lod) << level);
    range.low = std::min(range.low, std::min<std::int64_t>(0, overlay_rows(world, lod).lowest) << level);
  }
  return range;
}

MixedRange mixed_range(const World& world, Lod lod) {
  // At coarse levels the topmost solid voxel may lie just below y = 0.
  const std::int64_t low = std::min<std::int64_t>(lod.value() == 0 ? 0 : -1, overlay_rows(world, lod).lowest);
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
  return extract_chunk(world, generate_stacks(world, region_of_stacks(world, tile)), key.coord);
}

}  // namespace talus::terrain
