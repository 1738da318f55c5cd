// [[veins]]: ore in the rock (docs/DESIGN.md, "Veins and pockets"); ore_bodies.h has the shapes.
#include "features/ores.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string_view>

#include <talus/terrain/boundary_row.h>

#include <talus/terrain/lattice_hash.h>

#include "features/exposure.h"
#include "spec/units.h"

namespace talus::terrain {
namespace {

constexpr std::size_t kMaxOres = 16;
constexpr std::uint64_t kOreSeed = 0x4F52450000000000U;
// At least four voxels, so that a chunk reads at most (32 / 4 + 2)^3 cubes of a kind.
constexpr Range kSizes{4, 1024};        // voxels
constexpr Range kThicknesses{1, 1024};  // voxels

// A lobe's columns [west, east) and [north, south) of a chunk.
struct Columns {
  int west = 0;
  int east = 0;
  int north = 0;
  int south = 0;

  template <class Visit>
  bool all_of(const Visit& visit) const {
    for (int z = north; z < south; ++z) {
      for (int x = west; x < east; ++x) {
        if (!visit(column_index(x, z))) return false;
      }
    }
    return true;
  }

  template <class Visit>
  void for_each(const Visit& visit) const {
    (void)all_of([&](std::size_t i) {
      visit(i);
      return true;
    });
  }
};

Columns columns_of(const OreLobe& lobe, ChunkKey key) {
  const VoxelPos origin = chunk_origin(key.coord);
  const std::int64_t edge = kSubvoxels * (std::int64_t{1} << key.lod.value());
  const auto column = [&](std::int64_t at_fx, std::int64_t from) {
    return static_cast<int>(std::clamp<std::int64_t>(floor_div(at_fx, edge) - from, 0, kChunkSize));
  };
  return {column(lobe.x_fx - lobe.reach_fx, origin.x), column(lobe.x_fx + lobe.reach_fx + edge, origin.x),
          column(lobe.z_fx - lobe.reach_fx, origin.z), column(lobe.z_fx + lobe.reach_fx + edge, origin.z)};
}

// Cuts a lobe to the rows of rock in its columns; `highest` is the highest row of rock. True if any is left.
bool cut(const OreLobe& lobe, const Columns& columns, ChunkKey key, const ChunkPlane& rock, int highest,
         Overlay& overlay) {
  const int shift = key.lod.value();
  const VoxelPos origin = chunk_origin(key.coord);
  const std::int64_t step = std::int64_t{1} << shift;
  const std::int64_t low_fx = origin.y * step * kSubvoxels;
  const std::int64_t high_fx = (origin.y + highest) * step * kSubvoxels;
  bool any = false;
  for (int z = columns.north; z < columns.south; ++z) {
    OreRow along{lobe, (origin.z + z) * step, low_fx, high_fx};
    const OreRow::Reach reach = along.reach();
    const auto column_at = [&](std::int64_t base_x) {
      return static_cast<int>(
          std::clamp<std::int64_t>((base_x >> shift) - origin.x, columns.west, columns.east));
    };
    const int east = column_at(reach.to + step - 1);
    for (int x = column_at(reach.from); x < east; ++x) {
      const auto span = along.at((origin.x + x) * step);
      if (!span) continue;
      const std::size_t column = column_index(x, z);
      const auto row = [&](std::int32_t height_fx) {
        return static_cast<std::uint8_t>(
            std::clamp<std::int64_t>(boundary_row(height_fx >> shift) - origin.y, 0, rock[column]));
      };
      overlay.from[column] = row(span->from_fx);
      overlay.to[column] = row(span->to_fx);
      any = any || overlay.from[column] < overlay.to[column];
    }
  }
  return any;
}

// Merges a lobe into an overlay of its ore if both form one interval in every column.
bool join(const Overlay& lobe, const Columns& columns, Overlay& overlay) {
  const bool one_run = columns.all_of([&](std::size_t i) {
    const bool both = lobe.from[i] < lobe.to[i] && overlay.from[i] < overlay.to[i];
    return !both || (lobe.from[i] <= overlay.to[i] && lobe.to[i] >= overlay.from[i]);
  });
  if (!one_run) return false;
  columns.for_each([&](std::size_t i) {
    if (lobe.from[i] >= lobe.to[i]) return;
    const bool free = overlay.from[i] >= overlay.to[i];
    overlay.from[i] = free ? lobe.from[i] : std::min(overlay.from[i], lobe.from[i]);
    overlay.to[i] = free ? lobe.to[i] : std::max(overlay.to[i], lobe.to[i]);
  });
  return true;
}

// Adds the exposed voxels of an overlay: the k-th run of each column in the k-th overlay.
void add_exposed_runs(const Overlay& whole, const ExposedRows& exposed, std::vector<Overlay>& overlays) {
  const std::size_t first = overlays.size();
  for (std::size_t column = 0; column < kChunkArea; ++column) {
    if (whole.from[column] >= whole.to[column]) continue;
    const auto below = [](std::uint8_t row) { return (std::uint64_t{1} << row) - 1; };
    std::uint64_t left = exposed[column] & below(whole.to[column]) & ~below(whole.from[column]);
    for (std::size_t run = first; left != 0; ++run) {
      const int from = std::countr_zero(left);
      const int to = from + std::countr_one(left >> from);
      if (run == overlays.size()) overlays.push_back({whole.material, {}, {}});
      overlays[run].from[column] = static_cast<std::uint8_t>(from);
      overlays[run].to[column] = static_cast<std::uint8_t>(to);
      left &= ~below(static_cast<std::uint8_t>(to));
    }
  }
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

OreKind read_ore(FeatureSection& section, TableReader& table, std::uint64_t index) {
  const int resolution = section.spec().resolution;
  OreKind ore;
  ore.shape = static_cast<OreShape>(table.choice("shape", {"pocket", "vein"}));
  std::vector<std::string_view> known{"name", "colour", "shape", "low", "high", "size", "abundance"};
  if (ore.shape == OreShape::vein) known.push_back("thickness");
  table.only(known);
  ore.material = section.add_material(table, MaterialKind::stratified);
  const std::int64_t low_q16 = table.units_q16("low", {0, kMaxHeight});
  const std::int64_t high_q16 = table.length_q16("high", {0, kMaxHeight}, {resolution, {0, kMaxHeight}});
  const std::int64_t size_q16 = table.length_q16("size", {kMinUnits_q16, kMaxHeight}, {resolution, kSizes});
  std::int64_t thickness_q16 = 0;
  if (ore.shape == OreShape::vein) {
    thickness_q16 = table.length_q16("thickness", {kMinUnits_q16, kMaxHeight}, {resolution, kThicknesses});
    if (thickness_q16 > size_q16 / 4) {
      table.fail("thickness", "more than a quarter of size; make it at most that");
    }
  }
  if (high_q16 - low_q16 < size_q16) {
    table.fail("high", "less than size above low, so that no body fits; make it low + size or more");
  }
  const double abundance = table.real("abundance", {0, 1});

  const auto fx = [&](std::int64_t q16) { return static_cast<std::int32_t>(subvoxels_of(q16, resolution)); };
  ore.seed = derived_seed(section.spec().seed, kOreSeed + index);
  ore.low_fx = fx(low_q16);
  ore.high_fx = fx(high_q16);
  ore.size_fx = fx(size_q16);
  ore.thickness_fx = fx(thickness_q16);
  ore.chance_q32 = static_cast<std::uint64_t>(std::floor(abundance * 4294967296.0 + 0.5));
  return ore;
}

std::unique_ptr<const Feature> read_ores(FeatureSection& section) {
  auto tables = section.tables();
  if (tables.size() > kMaxOres) {
    tables[kMaxOres].fail("name", text_of(tables.size(), " ores; at most ", kMaxOres));
  }
  std::vector<OreKind> kinds;
  for (TableReader& table : tables) kinds.push_back(read_ore(section, table, kinds.size()));
  return std::make_unique<Ores>(std::move(kinds));
}

}  // namespace

void Ores::write_canonical_form(TextWriter& form) const {
  for (const OreKind& ore : kinds_) {
    form << "ore " << to_integer(ore.material) << " shape " << static_cast<int>(ore.shape) << " low_fx "
         << ore.low_fx << " high_fx " << ore.high_fx << " size_fx " << ore.size_fx << " thickness_fx "
         << ore.thickness_fx << " chance_q32 " << ore.chance_q32 << '\n';
  }
}

OverlayRows Ores::overlay_rows(Lod lod) const {
  OverlayRows rows;
  for (const OreKind& ore : kinds_) {
    if (!ore.shows_at(lod)) continue;
    rows.lowest = std::min<std::int64_t>(rows.lowest, boundary_row(ore.low_fx >> lod.value()));
  }
  return rows;
}

// The ore that is first in the spec wins where bodies overlap. Bodies of one ore share an overlay if each
// column has one interval of it.
void Ores::add_overlays(const ChunkSite& site, const Field* /*survey*/,
                        std::vector<Overlay>& overlays) const {
  const ChunkPlane& rock = site.rock();
  const int highest = *std::max_element(rock.begin(), rock.end());
  if (highest == 0) return;
  const bool only_exposed = view_ == SecretView::exposed && site.key().lod == Lod{};
  std::optional<ExposedRows> exposed;
  if (only_exposed && !(exposed = exposed_rows(site))) return;
  std::vector<OreLobe> lobes;
  for (std::size_t i = kinds_.size(); i-- > 0;) {
    const OreKind& kind = kinds_[i];
    if (!kind.shows_at(site.key().lod)) continue;
    lobes.clear();
    add_lobes(kind, box_of(site.key()), lobes);
    const std::size_t first = overlays.size();
    for (const OreLobe& lobe : lobes) {
      const Columns columns = columns_of(lobe, site.key());
      Overlay alone{kind.material, {}, {}};
      if (!cut(lobe, columns, site.key(), rock, highest, alone)) continue;
      const auto joined = std::any_of(overlays.begin() + static_cast<std::ptrdiff_t>(first), overlays.end(),
                                      [&](Overlay& overlay) { return join(alone, columns, overlay); });
      if (!joined) overlays.push_back(alone);
    }
    if (!exposed) continue;
    const std::vector<Overlay> whole{overlays.begin() + static_cast<std::ptrdiff_t>(first), overlays.end()};
    overlays.resize(first);
    for (const Overlay& each : whole) add_exposed_runs(each, *exposed, overlays);
  }
}

std::shared_ptr<const Feature> Ores::kept_secret(const SipHash& draw, SecretView view) const {
  std::vector<OreKind> kinds = kinds_;
  for (std::size_t i = 0; i < kinds.size(); ++i) kinds[i].secret = draw.with(i);
  return std::make_shared<const Ores>(std::move(kinds), view);
}

bool Ores::add_secret(ChunkCoord chunk, std::span<MaterialId, kChunkVolume> voxels) const {
  ChunkPlane rock;
  rock.fill(kChunkSize);
  const ChunkKey key{chunk, Lod{}};
  std::vector<OreLobe> lobes;
  bool any = false;
  for (std::size_t i = kinds_.size(); i-- > 0;) {
    if (!kinds_[i].secret) continue;
    lobes.clear();
    add_lobes(kinds_[i], box_of(key), lobes);
    for (const OreLobe& lobe : lobes) {
      Overlay alone{kinds_[i].material, {}, {}};
      if (!cut(lobe, columns_of(lobe, key), key, rock, kChunkSize, alone)) continue;
      write(alone, voxels);
      any = true;
    }
  }
  return any;
}

void Ores::add_exposed(const Stacks& stacks, const Field* /*survey*/, std::span<MaterialId> exposed) const {
  const Region& region = stacks.region;
  const Field& rock = stacks.rock_top();
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
  for (std::size_t i = kinds_.size(); i-- > 0;) {
    const OreKind& kind = kinds_[i];
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
        OreRow along{lobe, (region.z + z) * step};
        for (int x = west; x < east; ++x) {
          const auto span = along.at((region.x + x) * step);
          // The voxel under the surface of the rock, or under the floor of an open cave, at its centre.
          const std::int32_t row = boundary_row(std::min(rock.at(x, z), stacks.ground_fx(x, z))) - 1;
          // Loose material may fill only a part of the voxel above, which hides a secret's voxel all the
          // same.
          if (view_ == SecretView::exposed && row + 1 < boundary_row(stacks.ground_fx(x, z))) continue;
          if (span && row >= boundary_row(span->from_fx >> shift) &&
              row < boundary_row(span->to_fx >> shift)) {
            exposed[static_cast<std::size_t>(z) * static_cast<std::size_t>(region.width) +
                    static_cast<std::size_t>(x)] = kind.material;
          }
        }
      }
    }
  }
}

namespace features {

FeatureKind ores() {
  return {"veins", read_ores};
}

}  // namespace features
}  // namespace talus::terrain
