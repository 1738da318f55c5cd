// A feature that no program ships: [[lava]], lenses of lava in the rock and pools of it in hollows. It stands
// here to show what adding a kind of feature takes: this file, and its line in CMakeLists.txt. lava_test.cpp
// are its tests.
#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include <talus/terrain/boundary_row.h>
#include <talus/terrain/lattice_hash.h>
#include <talus/voxel/coords.h>

#include "feature.h"
#include "spec/units.h"

namespace talus::terrain {
namespace {

constexpr std::uint64_t kLavaSeed = 0x4C41564100000000U;
constexpr Range kSpacings{8, 4096};    // columns
constexpr Range kThicknesses{1, 512};  // voxels
constexpr double kMaxPoolReach = 16;   // columns

// One [[lava]]. The plane is cut into square cells; a lens lies wholly in its cell.
struct LavaKind {
  MaterialId material{};
  std::uint64_t seed = 0;
  std::int32_t low_fx = 0;  // of a lens' middle; may lie under y = 0
  std::int32_t high_fx = 0;
  std::int64_t spacing = 0;  // columns along a cell's edge
  std::int64_t radius = 0;   // columns, at most half of it
  std::int32_t half_fx = 0;  // half the thickness in the middle
  std::uint64_t chance_q32 = 0;
  int pool_reach = 0;  // columns; a column that is lowest within it holds a pool
  int pool_rows = 0;   // voxels of the level above the ground

  [[nodiscard]] bool shows_at(Lod lod) const { return half_fx >> lod.value() >= kSubvoxels / 2; }
  [[nodiscard]] int pool_reach_at(Lod lod) const { return pool_reach >> lod.value(); }

  struct Span {
    std::int32_t from_fx = 0;
    std::int32_t to_fx = 0;  // from_fx where there is no lava
  };
  // What of a base column is lava, in subvoxels of level 0.
  [[nodiscard]] Span at(std::int64_t x, std::int64_t z) const {
    const std::int64_t cell_x = floor_div(x, spacing);
    const std::int64_t cell_z = floor_div(z, spacing);
    const std::uint64_t cell = derived_seed(derived_seed(seed, static_cast<std::uint64_t>(cell_x)),
                                            static_cast<std::uint64_t>(cell_z));
    if (cell >> 32 >= chance_q32) return {};
    const auto draw = [&](std::uint64_t which, std::int64_t count) {
      const std::uint64_t bits = derived_seed(~cell, which) >> 32;
      return static_cast<std::int64_t>((bits * static_cast<std::uint64_t>(count)) >> 32);
    };
    const std::int64_t east = x - cell_x * spacing - radius - draw(0, spacing - 2 * radius + 1);
    const std::int64_t south = z - cell_z * spacing - radius - draw(1, spacing - 2 * radius + 1);
    const std::int64_t inside = radius * radius - east * east - south * south;
    if (inside <= 0) return {};
    const auto middle_fx = static_cast<std::int32_t>(low_fx + draw(2, std::int64_t{high_fx} - low_fx + 1));
    const auto here_fx = static_cast<std::int32_t>(half_fx * inside / (radius * radius));
    return {middle_fx - here_fx, middle_fx + here_fx};
  }
};

class Lava final : public Feature {
 public:
  explicit Lava(std::vector<LavaKind> kinds) : kinds_{std::move(kinds)} {}

  void write_canonical_form(TextWriter& form) const override {
    for (const LavaKind& kind : kinds_) {
      form << "lava " << to_integer(kind.material) << " low_fx " << kind.low_fx << " high_fx " << kind.high_fx
           << " spacing " << kind.spacing << " radius " << kind.radius << " half_fx " << kind.half_fx
           << " chance_q32 " << kind.chance_q32 << " pools " << kind.pool_reach << ' ' << kind.pool_rows
           << '\n';
    }
  }

  [[nodiscard]] int halo(Lod lod) const override {
    int halo = 0;
    for (const LavaKind& kind : kinds_) halo = std::max(halo, kind.pool_reach_at(lod));
    return halo;
  }

  [[nodiscard]] bool surveys() const override { return true; }
  // One bit a kind: whether no column within its reach lies lower.
  void survey(const Region& region, int around, const Field& height, Field& survey) const override {
    for (int z = 0; z < region.depth; ++z) {
      for (int x = 0; x < region.width; ++x) {
        std::int32_t hollows = 0;
        for (std::size_t i = 0; i < kinds_.size(); ++i) {
          const int reach = std::min(around, kinds_[i].pool_reach_at(region.lod));
          if (reach > 0 && lowest_within(reach, height, x + around, z + around)) hollows |= 1 << i;
        }
        survey.at(x, z) = hollows;
      }
    }
  }

  [[nodiscard]] OverlayRows overlay_rows(Lod lod) const override {
    OverlayRows rows;
    for (const LavaKind& kind : kinds_) {
      if (kind.shows_at(lod)) {
        const std::int32_t lowest_fx = kind.low_fx - kind.half_fx;
        rows.lowest = std::min<std::int64_t>(rows.lowest, boundary_row(lowest_fx >> lod.value()));
      }
      if (kind.pool_reach_at(lod) > 0) rows.above_ground = std::max(rows.above_ground, kind.pool_rows);
    }
    return rows;
  }

  void add_overlays(const ChunkSite& site, const Field* survey,
                    std::vector<Overlay>& overlays) const override {
    for (std::size_t i = kinds_.size(); i-- > 0;) {
      Overlay lenses{kinds_[i].material, {}, {}};
      if (cut_lenses(kinds_[i], site, lenses)) overlays.push_back(lenses);
      Overlay pools{kinds_[i].material, {}, {}};
      if (cut_pools(i, site, *survey, pools)) overlays.push_back(pools);
    }
  }

  void add_exposed(const Stacks& stacks, const Field* /*survey*/,
                   std::span<MaterialId> exposed) const override {
    const Region& region = stacks.region;
    for (std::size_t i = 0; i < exposed.size(); ++i) {
      const int x = static_cast<int>(i) % region.width;
      const int z = static_cast<int>(i) / region.width;
      const std::int32_t row = boundary_row(stacks.rock_top().at(x, z)) - 1;
      for (std::size_t k = kinds_.size(); k-- > 0;) {
        const auto [from, to] = rows_of(kinds_[k], region.x + x, region.z + z, region.lod);
        if (row >= from && row < to) exposed[i] = kinds_[k].material;
      }
    }
  }

 private:
  static bool lowest_within(int reach, const Field& height, int x, int z) {
    for (int south = -reach; south <= reach; ++south) {
      for (int east = -reach; east <= reach; ++east) {
        if (height.at(x + east, z + south) < height.at(x, z)) return false;
      }
    }
    return true;
  }

  // The rows of a lens in a column of a level.
  static std::pair<std::int32_t, std::int32_t> rows_of(const LavaKind& kind, std::int64_t x, std::int64_t z,
                                                       Lod lod) {
    if (!kind.shows_at(lod)) return {};
    const std::int64_t step = std::int64_t{1} << lod.value();
    const LavaKind::Span span = kind.at(x * step, z * step);
    return {boundary_row(span.from_fx >> lod.value()), boundary_row(span.to_fx >> lod.value())};
  }

  static bool cut_lenses(const LavaKind& kind, const ChunkSite& site, Overlay& lenses) {
    const VoxelPos origin = chunk_origin(site.key().coord);
    const ChunkPlane& rock = site.rock();
    bool any = false;
    for (std::size_t i = 0; i < kChunkArea; ++i) {
      const auto x = static_cast<std::int64_t>(i % kChunkSize);
      const auto z = static_cast<std::int64_t>(i / kChunkSize);
      const auto [from, to] = rows_of(kind, origin.x + x, origin.z + z, site.key().lod);
      const auto cut = [&](std::int64_t row) {
        return static_cast<std::uint8_t>(std::clamp<std::int64_t>(row - origin.y, 0, rock[i]));
      };
      lenses.from[i] = cut(from);
      lenses.to[i] = cut(to);
      any |= lenses.from[i] < lenses.to[i];
    }
    return any;
  }

  bool cut_pools(std::size_t kind, const ChunkSite& site, const Field& survey, Overlay& pools) const {
    const std::int64_t floor_row = chunk_origin(site.key().coord).y;
    bool any = false;
    for (std::size_t i = 0; i < kChunkArea; ++i) {
      const int x = site.x() + static_cast<int>(i % kChunkSize);
      const int z = site.z() + static_cast<int>(i / kChunkSize);
      if ((survey.at(x, z) >> kind & 1) == 0) continue;
      const std::int64_t ground = boundary_row(site.stacks().tops.back().at(x, z)) - floor_row;
      const auto cut = [](std::int64_t row) {
        return static_cast<std::uint8_t>(std::clamp<std::int64_t>(row, 0, kChunkSize));
      };
      pools.from[i] = cut(ground);
      pools.to[i] = cut(ground + kinds_[kind].pool_rows);
      any |= pools.from[i] < pools.to[i];
    }
    return any;
  }

  std::vector<LavaKind> kinds_;
};

LavaKind read_kind(FeatureSection& section, TableReader& table, std::uint64_t index) {
  table.only({"name", "colour", "low", "high", "spacing", "radius", "thickness", "abundance", "pool_reach",
              "pool_rows"});
  const int resolution = section.spec().resolution;
  LavaKind kind;
  kind.material = section.add_material(table, MaterialKind::stratified);
  constexpr Range kHeights{-kMaxHeight, kMaxHeight};
  const std::int64_t low_q16 = table.length_q16("low", kHeights, {resolution, kHeights});
  const std::int64_t high_q16 = table.length_q16("high", kHeights, {resolution, kHeights});
  if (high_q16 < low_q16) table.fail("high", "less than low; make it low or more");
  const double spacing = table.length("spacing", {kMinLength, kMaxLength}, {resolution, kSpacings});
  const double radius = table.length("radius", {kMinLength, kMaxLength}, {resolution, {1, kSpacings.max}});
  if (radius > spacing / 2) table.fail("radius", "more than half of spacing; make it at most that");
  const std::int64_t thickness_q16 =
      table.length_q16("thickness", {kMinUnits_q16, kMaxHeight}, {resolution, kThicknesses});
  const double abundance = table.real("abundance", {0, 1});
  const double pool_reach =
      table.has("pool_reach") ? table.length("pool_reach", {0, kMaxHeight}, {resolution, {0, kMaxPoolReach}})
                              : 0;
  const std::int64_t pool_rows = table.has("pool_rows") ? table.integer("pool_rows", 1, 64) : 1;

  const auto fx = [&](std::int64_t q16) { return static_cast<std::int32_t>(subvoxels_of(q16, resolution)); };
  kind.seed = derived_seed(section.spec().seed, kLavaSeed + index);
  kind.low_fx = fx(low_q16);
  kind.high_fx = fx(high_q16);
  kind.spacing = rounded(spacing * resolution);
  kind.radius = std::min(rounded(radius * resolution), kind.spacing / 2);
  kind.half_fx = fx(thickness_q16) / 2;
  kind.chance_q32 = static_cast<std::uint64_t>(rounded(abundance * 4294967296.0));
  kind.pool_reach = static_cast<int>(rounded(pool_reach * resolution));
  kind.pool_rows = static_cast<int>(pool_rows);
  return kind;
}

std::unique_ptr<const Feature> read(FeatureSection& section) {
  auto tables = section.tables();
  constexpr std::size_t kMaxKinds = 8;
  if (tables.size() > kMaxKinds) {
    tables[kMaxKinds].fail("name", text_of(tables.size(), " kinds of lava; at most ", kMaxKinds));
  }
  std::vector<LavaKind> kinds;
  for (TableReader& table : tables) kinds.push_back(read_kind(section, table, kinds.size()));
  return std::make_unique<Lava>(std::move(kinds));
}

}  // namespace

namespace features {

FeatureKind lava() {
  return {"lava", read};
}

}  // namespace features
}  // namespace talus::terrain
