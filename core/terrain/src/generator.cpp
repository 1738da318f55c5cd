#include <talus/terrain/generator.h>

#include <algorithm>
#include <memory>
#include <utility>

#include <talus/terrain/erosion.h>
#include <talus/terrain/surface.h>

#include "feature.h"
#include "kernels/columns.h"
#include "loose/settle_grid.h"
#include "strata/strata_builder.h"
#include "surface/ground.h"

namespace talus::terrain {
namespace {

void base_columns(std::int64_t first, int count, Lod lod, std::vector<std::int64_t>& columns) {
  columns.clear();
  for (int i = 0; i < count; ++i) columns.push_back((first + i) * (std::int64_t{1} << lod.value()));
}

void lower(const ColumnKernels& kernels, std::span<const std::int32_t> top, const std::int16_t* thickness,
           std::span<std::int32_t> lowered) {
  kernels.lower_int16(top.data(), thickness, top.size(), lowered.data());
}

void lower(const ColumnKernels& kernels, std::span<const std::int32_t> top, const std::int32_t* thickness,
           std::span<std::int32_t> lowered) {
  kernels.lower_int32(top.data(), thickness, top.size(), lowered.data());
}

// A slope on which nothing stays.
constexpr std::int32_t kSheer_fx = 1 << 30;

void shift_right(Field& field, int shift) {
  if (shift == 0) return;
  for (std::int32_t& value : field.values) value >>= shift;
}

void shift_left(Field& field, int shift) {
  if (shift == 0) return;
  for (std::int32_t& value : field.values) value <<= shift;
}

}  // namespace

struct Generator::Scratch {
  explicit Scratch(const World& world)
      : set{instruction_set()},
        ground{surface_of(world.spec()), set},
        strata{world, set},
        grid{set},
        columns{column_kernels(set)},
        carver{make_carver(world, set)},
        surveys(world.features().size()) {}

  InstructionSet set;
  Ground ground;
  StrataBuilder strata;
  SettleGrid grid;
  const ColumnKernels& columns;
  std::unique_ptr<Carver> carver;
  std::vector<Field> surveys;  // one a feature; empty where it keeps nothing
  int around = 0;              // columns around the region that `ground` covers
  Field slope;                 // for loose material, where it is not `ground`'s
  std::vector<std::int64_t> xs;
  std::vector<std::int64_t> zs;
  Field limit;
  std::vector<Field> loose_tops;  // bottom up
  std::vector<Field> spare;
  Eroder eroder;
  Field surface;  // H with its halo, before erosion
  LooseGround loose_ground;
  std::vector<LooseRules> rules;  // bottom up
};

namespace {

int loose_halo(const World& world, Lod lod) {
  if (world.spec().method == Method::erosion) return 2 * world.erosion_steps_at(lod);
  int halo = 0;
  for (const LooseSpec& loose : world.loose()) halo = std::max(halo, loose.halo_at(lod));
  return halo;
}

}  // namespace

int halo_columns(const World& world, Lod lod) {
  return std::max(loose_halo(world, lod), world.feature_halo(lod));
}

Generator::Generator(const World& world) : world_{&world}, scratch_{std::make_unique<Scratch>(world)} {}
Generator::~Generator() = default;
Generator::Generator(Generator&&) noexcept = default;
Generator& Generator::operator=(Generator&&) noexcept = default;

void Generator::generate(const Region& region, Terrain& terrain) {
  generate_with_halo(region, std::max(1, halo_columns(*world_, region.lod)), terrain);
}

void Generator::compute_ground(const Region& region, int ring, int halo) {
  Scratch& s = *scratch_;
  const int for_entrances = s.carver ? s.carver->entrance_halo(region.lod) : 0;
  s.around = std::max(ring + for_entrances, std::min(halo, world_->feature_halo(region.lod)));
  s.ground.compute(region.expanded(s.around));
  if (s.carver) s.carver->compute(region, s.around, ring, s.ground.height());
  for (std::size_t i = 0; i < s.surveys.size(); ++i) {
    const Feature& feature = *world_->features()[i];
    if (!feature.surveys()) continue;
    s.surveys[i].reshape(region.width, region.depth);
    feature.survey(region, s.around, s.ground.height(), s.surveys[i]);
  }
}

const Field& Generator::slope_for_loose(int ring) {
  Scratch& s = *scratch_;
  if (s.around == ring && !s.carver) return s.ground.slope();
  s.ground.slope().crop_into(s.around - ring, s.slope);
  if (!s.carver) return s.slope;
  const Field& entrances = s.carver->entrances();
  for (std::size_t i = 0; i < entrances.values.size(); ++i) {
    if (entrances.values[i] != Carver::kClosed) s.slope.values[i] = kSheer_fx;
  }
  return s.slope;
}

void Generator::generate_with_halo(const Region& region, int halo, Terrain& terrain) {
  Scratch& s = *scratch_;
  const bool erodes = world_->spec().method == Method::erosion;
  terrain.region = region;
  terrain.loose.resize(world_->loose().size());
  if (erodes) {
    const int ring = std::min(halo, loose_halo(*world_, region.lod));
    erode(region, ring, halo);
    s.ground.slope().crop_into(s.around, terrain.slope);
    take_eroded(ring, terrain);
    build_strata(terrain);
    take_caves(ring, terrain.surface, terrain.caves);
    return;
  }

  // The outermost column of the halo serves the slope alone.
  const int ring = std::clamp(loose_halo(*world_, region.lod), 1, halo) - 1;
  compute_ground(region, ring, halo);
  s.ground.slope().crop_into(s.around, terrain.slope);
  s.ground.height().crop_into(s.around, terrain.surface);
  build_strata(terrain);
  take_caves(ring, terrain.surface, terrain.caves);
  const Field& slope = slope_for_loose(ring);
  for (std::size_t m = 0; m < terrain.loose.size(); ++m) {
    const LooseSpec& loose = world_->loose()[m];
    s.grid.start(slope, loose.thickness_at(region.lod), loose.S_fx);
    s.grid.settle(loose.c_fx);
    terrain.loose[m].reshape(region.width, region.depth);
    for (int z = 0; z < region.depth; ++z) {
      s.grid.with_row(z + ring, [&](const auto* row) {
        std::copy_n(row + ring, region.width, terrain.loose[m].row(z).begin());
      });
    }
  }
}

/// `surface` is in subvoxels of level 0, and of the region's level from then on.
void Generator::build_strata(Terrain& terrain) {
  Scratch& s = *scratch_;
  const Region& region = terrain.region;
  const int shift = region.lod.value();
  base_columns(region.x, region.width, region.lod, s.xs);
  base_columns(region.z, region.depth, region.lod, s.zs);
  Planes strata{terrain.strata_materials, terrain.strata, s.spare};
  s.strata.build(s.xs, s.zs, terrain.surface, StrataBuilder::Extent::all, strata);
  for (Field& plane : terrain.strata) shift_right(plane, shift);
  shift_right(terrain.surface, shift);
}

std::int64_t Generator::generate_to_rest(const Region& region, Neighbours neighbours, Terrain& terrain) {
  Scratch& s = *scratch_;
  set_loose_over(region, 0, halo_columns(*world_, region.lod));
  Eroder eroder{neighbours};
  const std::int64_t steps = eroder.rest(s.rules, s.loose_ground);
  terrain.region = region;
  s.ground.slope().crop_into(s.around, terrain.slope);
  terrain.loose.resize(world_->loose().size());
  take_eroded(0, terrain);
  build_strata(terrain);
  take_caves(0, terrain.surface, terrain.caves);
  return steps;
}

void Generator::generate(const Region& region, Stacks& stacks) {
  Scratch& s = *scratch_;
  const int shift = region.lod.value();
  stacks.region = region;
  const bool erodes = world_->spec().method == Method::erosion;
  const int ring = erodes ? loose_halo(*world_, region.lod) : 0;
  if (erodes) {
    erode(region, ring, halo_columns(*world_, region.lod));
    take_eroded(ring);
  } else {
    settle(region);
  }

  base_columns(region.x, region.width, region.lod, s.xs);
  base_columns(region.z, region.depth, region.lod, s.zs);
  shift_left(s.limit, shift);  // strata are built in subvoxels of level 0
  Planes planes{stacks.materials, stacks.tops, s.spare};
  s.strata.build(s.xs, s.zs, s.limit, StrataBuilder::Extent::until_full, planes);
  for (Field& plane : stacks.tops) shift_right(plane, shift);
  const std::vector<std::size_t>& bottom_up = world_->loose_bottom_up();
  for (std::size_t i = 0; i < bottom_up.size(); ++i) {
    std::swap(planes.add(world_->loose()[bottom_up[i]].material), s.loose_tops[i]);
  }
  stacks.loose_planes = bottom_up.size();
  take_caves(ring, stacks.tops.back(), stacks.caves);
  take_surveys(stacks.surveys);
}

void Generator::settle(const Region& region) {
  Scratch& s = *scratch_;
  const int ring = std::max(1, loose_halo(*world_, region.lod)) - 1;
  compute_ground(region, ring, halo_columns(*world_, region.lod));
  const Field& slope = slope_for_loose(ring);
  // `limit` walks down from H: the top of the loose material whose turn it is, lightest first, then of rock.
  s.ground.height().crop_into(s.around, s.limit);
  shift_right(s.limit, region.lod.value());
  const std::vector<std::size_t>& bottom_up = world_->loose_bottom_up();
  s.loose_tops.resize(bottom_up.size());
  for (std::size_t i = bottom_up.size(); i-- > 0;) {
    const LooseSpec& loose = world_->loose()[bottom_up[i]];
    s.grid.start(slope, loose.thickness_at(region.lod), loose.S_fx);
    s.grid.settle(loose.c_fx);
    std::swap(s.loose_tops[i], s.limit);
    s.limit.reshape(region.width, region.depth);
    for (int z = 0; z < region.depth; ++z) {
      s.grid.with_row(z + ring, [&](const auto* row) {
        lower(s.columns, s.loose_tops[i].row(z), row + ring, s.limit.row(z));
      });
    }
  }
}

void Generator::erode(const Region& region, int ring, int halo) {
  Scratch& s = *scratch_;
  set_loose_over(region, ring, halo);
  for (int step = 0; step < world_->erosion_steps_at(region.lod); ++step) {
    if (!s.eroder.step(s.rules, s.loose_ground)) break;
  }
}

void Generator::set_loose_over(const Region& region, int ring, int halo) {
  Scratch& s = *scratch_;
  compute_ground(region, ring, halo);
  s.ground.height().crop_into(s.around - ring, s.surface);
  shift_right(s.surface, region.lod.value());
  s.rules.clear();
  for (const std::size_t m : world_->loose_bottom_up()) {
    const LooseSpec& loose = world_->loose()[m];
    s.rules.push_back({loose.thickness_at(region.lod), loose.c_fx});
  }
  set_loose(s.surface, s.rules, s.loose_ground);
  if (!s.carver) return;
  // Entrances are bare ground from the start.
  const Field& entrances = s.carver->entrances();
  for (std::size_t i = 0; i < entrances.values.size(); ++i) {
    if (entrances.values[i] == Carver::kClosed) continue;
    s.loose_ground.base.values[i] = entrances.values[i];
    for (Field& thickness : s.loose_ground.thickness) thickness.values[i] = 0;
  }
}

void Generator::take_eroded(int ring, Terrain& terrain) {
  Scratch& s = *scratch_;
  s.loose_ground.surface().crop_into(ring, terrain.surface);
  shift_left(terrain.surface, terrain.region.lod.value());
  for (std::size_t i = 0; i < terrain.loose.size(); ++i) {
    s.loose_ground.thickness[i].crop_into(ring, terrain.loose[world_->loose_bottom_up()[i]]);
  }
}

void Generator::take_eroded(int ring) {
  Scratch& s = *scratch_;
  s.loose_ground.base.crop_into(ring, s.limit);
  s.loose_tops.resize(s.rules.size());
  for (std::size_t i = 0; i < s.rules.size(); ++i) {
    Field& top = s.loose_tops[i];
    s.loose_ground.thickness[i].crop_into(ring, top);
    const Field& below = i == 0 ? s.limit : s.loose_tops[i - 1];
    for (std::size_t k = 0; k < top.values.size(); ++k) top.values[k] += below.values[k];
  }
}

void Generator::take_caves(int ring, const Field& surface, CaveAir& air) {
  Scratch& s = *scratch_;
  if (!s.carver) return air.clear();
  s.carver->take(air);
  const Field& entrances = s.carver->entrances();
  if (air.none() || entrances.values.empty() || world_->spec().method != Method::erosion) return;
  // What has slid into an entrance lies on its floor.
  for (int z = 0; z < surface.depth; ++z) {
    for (int x = 0; x < surface.width; ++x) {
      if (entrances.at(x + ring, z + ring) != Carver::kClosed) air.floor.at(x, z) = surface.at(x, z);
    }
  }
}

void Generator::take_surveys(std::vector<Field>& surveys) {
  surveys.resize(scratch_->surveys.size());
  for (std::size_t i = 0; i < surveys.size(); ++i) {
    if (world_->features()[i]->surveys()) {
      std::swap(surveys[i], scratch_->surveys[i]);
    } else {
      surveys[i].reshape(0, 0);
    }
  }
}

Terrain generate_terrain(const World& world, const Region& region) {
  Terrain terrain;
  Generator{world}.generate(region, terrain);
  return terrain;
}

Stacks generate_stacks(const World& world, const Region& region) {
  Stacks stacks;
  Generator{world}.generate(region, stacks);
  return stacks;
}

}  // namespace talus::terrain
