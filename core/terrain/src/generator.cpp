#include <talus/terrain/generator.h>

#include <algorithm>
#include <cassert>
#include <memory>
#include <optional>
#include <utility>

#include <talus/terrain/erosion.h>
#include <talus/terrain/surface.h>

#include "feature.h"
#include "kernels/columns.h"
#include "loose/settle_grid.h"
#include "place/places.h"
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

// A slope on which no material stays.
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
  Scratch(const World& world, std::shared_ptr<GroundCache> cache)
      : set{instruction_set()},
        ground{world, set, true, std::move(cache)},
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
  Region region;
  int ring = 0;                // columns around the region that loose material needs
  int around = 0;              // columns around it that `ground` covers
  int open_ring = 0;           // columns around it whose entrances are known
  std::vector<Field> surveys;  // one per feature; empty if it does not survey
  std::size_t survey = 0;      // next feature to survey
  Field slope;                 // for loose material, if it differs from `ground`'s
  Field entrances;             // cropped to a smaller ring
  std::vector<Field> most;     // of loose materials, bottom up, for erosion
  const Field* loose_slope = nullptr;
  int slope_ring = 0;  // columns of it outside of what loose material needs
  std::vector<std::int64_t> xs;
  std::vector<std::int64_t> zs;
  Field limit;
  std::vector<Field> loose_tops;  // bottom up
  std::vector<Field> spare;
  Eroder eroder;
  Field surface;  // H with its halo, before erosion
  LooseGround loose_ground;
  std::vector<LooseRules> rules;  // bottom up
  int erosion_steps = 0;          // steps left
  std::size_t erosion_piece = 0;  // of the step: see_surface() of each material, then step_material()
  bool moved = false;             // in this step

  enum class Stage : std::uint8_t { none, ground, loose, strata, objects };
  Stage stage = Stage::none;
  std::size_t unsettled = 0;  // number of materials left
  Stacks stacks;
  std::optional<Planes> planes;       // view of `stacks` while strata are built
  const Feature* standing = nullptr;  // the feature whose objects are placed
  Placement placement;
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

Generator::Generator(const World& world, std::shared_ptr<GroundCache> cache)
    : world_{&world}, scratch_{std::make_unique<Scratch>(world, std::move(cache))} {}
Generator::~Generator() = default;
Generator::Generator(Generator&&) noexcept = default;
Generator& Generator::operator=(Generator&&) noexcept = default;

void Generator::generate(const Region& region, Terrain& terrain) {
  generate_with_halo(region, std::max(1, halo_columns(*world_, region.lod)), terrain);
}

void Generator::compute_ground(const Region& region, int ring, int halo) {
  start_ground(region, ring, halo);
  while (step_ground(kColumnsAPiece)) {
  }
}

void Generator::start_ground(const Region& region, int ring, int halo) {
  Scratch& s = *scratch_;
  s.stage = Scratch::Stage::none;  // cancels earlier work
  s.planes.reset();
  s.region = region;
  s.ring = ring;
  const int for_entrances = s.carver ? s.carver->entrance_halo(region.lod) : 0;
  s.open_ring = ring;
  for (const auto& feature : world_->features()) {
    if (feature->stands()) s.open_ring = std::max(s.open_ring, feature->halo(region.lod));
  }
  s.around = std::max(s.open_ring + for_entrances, std::min(halo, world_->feature_halo(region.lod)));
  s.ground.start(region.expanded(s.around));
  if (s.carver) s.carver->start(region, s.around, s.open_ring);
  s.survey = 0;
}

bool Generator::step_ground(int columns) {
  Scratch& s = *scratch_;
  const int rows = std::max(1, columns / (s.region.width + 2 * s.around));
  if (s.ground.pending()) {
    s.ground.compute_rows(rows);
    return true;
  }
  if (s.carver && s.carver->pending()) {
    s.carver->compute_rows(rows, s.ground.height());
    return true;
  }
  while (s.survey < s.surveys.size()) {
    const std::size_t i = s.survey++;
    const Feature& feature = *world_->features()[i];
    if (!feature.surveys()) continue;
    s.surveys[i].reshape(s.region.width, s.region.depth);
    feature.survey(s.region, s.around, s.ground.height(), s.surveys[i]);
    return true;
  }
  return false;
}

/// Empty if all columns are closed.
const Field& Generator::entrances_around(int ring) {
  Scratch& s = *scratch_;
  const Field& all = s.carver->entrances();
  if (ring == s.open_ring || all.values.empty()) return all;
  all.crop_into(s.open_ring - ring, s.entrances);
  return s.entrances;
}

/// Over the region and `ring` columns around it. In entrances the slope is kSheer_fx.
void Generator::find_loose_slope(int ring) {
  Scratch& s = *scratch_;
  const Field& ground = s.ground.slope();
  s.loose_slope = &ground;
  s.slope_ring = s.around - ring;
  if (!s.carver || s.carver->entrances().values.empty()) return;
  const Field& entrances = s.carver->entrances();
  const int open_ring = s.open_ring - ring;
  s.slope.reshape(s.region.width + 2 * ring, s.region.depth + 2 * ring);
  for (int z = 0; z < s.slope.depth; ++z) {
    const std::int32_t* const open = entrances.row(z + open_ring).data() + open_ring;
    const std::int32_t* const own = ground.row(z + s.slope_ring).data() + s.slope_ring;
    const auto row = s.slope.row(z);
    for (std::size_t x = 0; x < row.size(); ++x) row[x] = open[x] == Carver::kClosed ? own[x] : kSheer_fx;
  }
  s.loose_slope = &s.slope;
  s.slope_ring = 0;
}

void Generator::generate_with_halo(const Region& region, int halo, Terrain& terrain) {
  Scratch& s = *scratch_;
  const bool erodes = world_->spec().method == Method::erosion;
  terrain.region = region;
  terrain.loose.resize(world_->loose().size());
  if (erodes) {
    const int ring = std::min(halo, loose_halo(*world_, region.lod));
    compute_ground(region, ring, halo);
    take_places(terrain);
    set_loose_over_ground();
    while (step_erosion()) {
    }
    s.ground.slope().crop_into(s.around, terrain.slope);
    take_eroded(ring, terrain);
    build_strata(terrain);
    take_caves(ring, terrain.surface, terrain.caves);
    return;
  }

  // The halo's outermost column is used only for the slope.
  const int ring = std::clamp(loose_halo(*world_, region.lod), 1, halo) - 1;
  compute_ground(region, ring, halo);
  take_places(terrain);
  s.ground.slope().crop_into(s.around, terrain.slope);
  s.ground.height().crop_into(s.around, terrain.surface);
  build_strata(terrain);
  take_caves(ring, terrain.surface, terrain.caves);
  find_loose_slope(ring);
  for (std::size_t m = 0; m < terrain.loose.size(); ++m) {
    const LooseSpec& loose = world_->loose()[m];
    start_grid(loose, ring);
    s.grid.settle(loose.c_fx);
    terrain.loose[m].reshape(region.width, region.depth);
    for (int z = 0; z < region.depth; ++z) {
      s.grid.with_row(z + ring, [&](const auto* row) {
        std::copy_n(row + ring, region.width, terrain.loose[m].row(z).begin());
      });
    }
  }
  add_aprons(terrain);
}

/// The aprons' material reaches down to the bare ground, under all lighter materials.
void Generator::add_aprons(Terrain& terrain) {
  if (!world_->spec().talus) return;
  Field top = terrain.surface;
  for (std::size_t i = world_->loose_bottom_up().size(); i-- > 0;) {
    Field& loose = terrain.loose[world_->loose_bottom_up()[i]];
    for (std::size_t k = 0; k < top.values.size(); ++k) {
      const std::int32_t room = top.values[k] - terrain.bare.values[k];
      if (is_talus(i)) loose.values[k] = std::max(loose.values[k], room);
      top.values[k] = std::max(top.values[k] - loose.values[k], 0);
    }
    if (is_talus(i)) return;
  }
}

/// Converts `surface` from subvoxels of level 0 to the region's level.
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
  terrain.region = region;
  compute_ground(region, 0, halo_columns(*world_, region.lod));
  take_places(terrain);
  set_loose_over_ground();
  Eroder eroder{neighbours};
  const std::int64_t steps = eroder.rest(s.rules, s.loose_ground);
  s.ground.slope().crop_into(s.around, terrain.slope);
  terrain.loose.resize(world_->loose().size());
  take_eroded(0, terrain);
  build_strata(terrain);
  take_caves(0, terrain.surface, terrain.caves);
  return steps;
}

void Generator::generate(const Region& region, Stacks& stacks) {
  start(region, std::move(stacks));
  while (step()) {
  }
  stacks = take();
}

void Generator::start(const Region& region, Stacks memory) {
  Scratch& s = *scratch_;
  const bool erodes = world_->spec().method == Method::erosion;
  const int loose = loose_halo(*world_, region.lod);
  start_ground(region, erodes ? loose : std::max(1, loose) - 1, halo_columns(*world_, region.lod));
  s.stacks = std::move(memory);
  s.stacks.region = region;
  s.stage = Scratch::Stage::ground;
}

bool Generator::step(int columns) {
  Scratch& s = *scratch_;
  switch (s.stage) {
    case Scratch::Stage::ground:
      if (step_ground(columns)) return true;
      start_loose();
      s.stage = Scratch::Stage::loose;
      return true;
    case Scratch::Stage::loose:
      if (step_loose()) return true;
      start_strata();
      s.stage = Scratch::Stage::strata;
      return true;
    case Scratch::Stage::strata:
      if (s.strata.pending()) {
        s.strata.step();
        return true;
      }
      finish();
      start_objects(s.stacks.objects);
      s.stage = Scratch::Stage::objects;
      return true;
    case Scratch::Stage::objects:
      if (step_objects(columns, s.stacks.objects)) return true;
      s.stage = Scratch::Stage::none;
      return false;
    case Scratch::Stage::none:
      return false;
  }
  return false;
}

Stacks Generator::take() {
  assert(scratch_->stage == Scratch::Stage::none);
  return std::move(scratch_->stacks);
}

void Generator::start_strata() {
  Scratch& s = *scratch_;
  const Region& region = s.region;
  if (world_->spec().method == Method::erosion) take_eroded(s.ring);
  base_columns(region.x, region.width, region.lod, s.xs);
  base_columns(region.z, region.depth, region.lod, s.zs);
  shift_left(s.limit, region.lod.value());  // strata are built in subvoxels of level 0
  s.planes.emplace(s.stacks.materials, s.stacks.tops, s.spare);
  s.strata.start(s.xs, s.zs, s.limit, StrataBuilder::Extent::until_full, *s.planes);
}

void Generator::finish() {
  Scratch& s = *scratch_;
  for (Field& plane : s.stacks.tops) shift_right(plane, s.region.lod.value());
  const std::vector<std::size_t>& bottom_up = world_->loose_bottom_up();
  for (std::size_t i = 0; i < bottom_up.size(); ++i) {
    std::swap(s.planes->add(world_->loose()[bottom_up[i]].material), s.loose_tops[i]);
  }
  s.planes.reset();
  s.stacks.loose_planes = bottom_up.size();
  take_caves(world_->spec().method == Method::erosion ? s.ring : 0, s.stacks.tops.back(), s.stacks.caves);
  take_surveys(s.stacks.surveys);
  take_looks(s.stacks.looks);
}

void Generator::start_loose() {
  Scratch& s = *scratch_;
  if (world_->spec().method == Method::erosion) return set_loose_over_ground();
  // `limit` descends from H: first the top of the lightest loose material, and finally the top of rock.
  s.ground.height().crop_into(s.around, s.limit);
  shift_right(s.limit, s.region.lod.value());
  find_loose_slope(s.ring);
  s.unsettled = world_->loose_bottom_up().size();
  s.loose_tops.resize(s.unsettled);
}

bool Generator::step_loose() {
  Scratch& s = *scratch_;
  if (world_->spec().method == Method::erosion) return step_erosion();
  if (s.unsettled == 0) return false;
  settle(--s.unsettled);
  return true;
}

void Generator::settle(std::size_t place) {
  Scratch& s = *scratch_;
  const LooseSpec& loose = world_->loose()[world_->loose_bottom_up()[place]];
  const bool none = loose.share && s.ground.shares()[*loose.share].values.empty();
  if (none && !is_talus(place)) {
    s.loose_tops[place].values = s.limit.values;
    s.loose_tops[place].reshape(s.region.width, s.region.depth);
    return;
  }
  start_grid(loose, s.ring);
  s.grid.settle(loose.c_fx);
  std::swap(s.loose_tops[place], s.limit);
  s.limit.reshape(s.region.width, s.region.depth);
  for (int z = 0; z < s.region.depth; ++z) {
    s.grid.with_row(z + s.ring, [&](const auto* row) {
      lower(s.columns, s.loose_tops[place].row(z), row + s.ring, s.limit.row(z));
    });
  }
  if (is_talus(place)) cut_at_bare(s.limit);
}

bool Generator::step_erosion() {
  Scratch& s = *scratch_;
  if (s.erosion_steps == 0) return false;
  const std::size_t materials = s.rules.size();
  if (s.erosion_piece < materials) {
    s.eroder.see_surface(s.erosion_piece, s.loose_ground);
  } else {
    const std::size_t m = s.erosion_piece - materials;
    s.moved |= s.eroder.step_material(m, s.rules[m], s.loose_ground);
  }
  if (++s.erosion_piece < 2 * materials) return true;
  s.erosion_steps = s.moved ? s.erosion_steps - 1 : 0;
  s.erosion_piece = 0;
  s.moved = false;
  return true;
}

void Generator::set_loose_over_ground() {
  Scratch& s = *scratch_;
  s.erosion_steps = world_->erosion_steps_at(s.region.lod);
  s.erosion_piece = 0;
  s.moved = false;
  s.ground.height().crop_into(s.around - s.ring, s.surface);
  shift_right(s.surface, s.region.lod.value());
  s.rules.clear();
  for (const std::size_t m : world_->loose_bottom_up()) {
    const LooseSpec& loose = world_->loose()[m];
    s.rules.push_back({loose.thickness_at(s.region.lod), loose.c_fx});
  }
  s.most.resize(s.rules.size());
  for (std::size_t i = 0; i < s.rules.size(); ++i) {
    const LooseSpec& loose = world_->loose()[world_->loose_bottom_up()[i]];
    Field& most = s.most[i];
    most.reshape(0, 0);
    if (!loose.share && !is_talus(i)) continue;
    if (loose.share) {
      crop_share(*loose.share, s.ring, most);
    } else {
      most.reshape(s.surface.width, s.surface.depth);
      std::fill(most.values.begin(), most.values.end(), kWholeShare);
    }
    for (std::int32_t& value : most.values) value = loose.thickness_at(s.region.lod, value);
    if (is_talus(i)) add_aprons(most);
  }
  set_loose(s.surface, s.rules, s.most, s.loose_ground);
  if (!s.carver) return;
  // Entrances are bare ground from the start.
  const Field& entrances = entrances_around(s.ring);
  for (std::size_t i = 0; i < entrances.values.size(); ++i) {
    if (entrances.values[i] == Carver::kClosed) continue;
    s.loose_ground.base.values[i] = entrances.values[i];
    for (Field& thickness : s.loose_ground.thickness) thickness.values[i] = 0;
  }
}

/// Adds the aprons to the thickness of their material, over the region and its ring.
void Generator::add_aprons(Field& thickness) {
  const Scratch& s = *scratch_;
  const int ring = s.around - s.ring;
  const int bare_ring = ring + s.ground.bare_ring();
  for (int z = 0; z < thickness.depth; ++z) {
    for (int x = 0; x < thickness.width; ++x) {
      const std::int32_t apron_fx =
          s.ground.height().at(x + ring, z + ring) - s.ground.bare().at(x + bare_ring, z + bare_ring);
      thickness.at(x, z) += apron_fx >> s.region.lod.value();
    }
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
  const Field& entrances = entrances_around(ring);
  if (air.none() || entrances.values.empty() || world_->spec().method != Method::erosion) return;
  // Material that has slid into an entrance lies on its floor.
  for (int z = 0; z < surface.depth; ++z) {
    for (int x = 0; x < surface.width; ++x) {
      if (entrances.at(x + ring, z + ring) != Carver::kClosed) air.floor.at(x, z) = surface.at(x, z);
    }
  }
}

bool Generator::is_talus(std::size_t place) const {
  return world_->spec().talus && world_->spec().talus->of == world_->loose_bottom_up()[place];
}

/// Aprons consist of one loose material down to the bare ground. `top` is in the level's subvoxels.
void Generator::cut_at_bare(Field& top) const {
  const Scratch& s = *scratch_;
  const int ring = s.around + s.ground.bare_ring();
  for (int z = 0; z < top.depth; ++z) {
    s.columns.cut_at(s.ground.bare().row(z + ring).data() + ring, s.region.lod.value(),
                     static_cast<std::size_t>(top.width), top.row(z).data());
  }
}

/// Starts the thickness before settling, by slope and place, over the region and `ring` columns around it.
void Generator::start_grid(const LooseSpec& loose, int ring) {
  Scratch& s = *scratch_;
  const Lod lod = s.region.lod;
  const std::int32_t steepest_fx = loose.steepest_at(lod);
  const int width = s.region.width + 2 * ring;
  const int depth = s.region.depth + 2 * ring;
  const Field* const share = loose.share ? &s.ground.shares()[*loose.share] : nullptr;
  const int share_ring = s.around - ring;
  s.grid.begin(width, depth, loose.thickness_at(lod));
  for (int z = 0; z < depth; ++z) {
    const std::int32_t* const slope = s.loose_slope->row(z + s.slope_ring).data() + s.slope_ring;
    if (share == nullptr || s.ground.places()->is_whole(*loose.share, z + share_ring)) {
      s.grid.start_row(z, slope, loose.thickness_at(lod), steepest_fx);
    } else if (share->values.empty()) {
      s.grid.start_row(z, slope, 0, steepest_fx);
    } else {
      s.grid.start_row(z, slope, share->row(z + share_ring).data() + share_ring, loose.t_fx,
                       kWholeShare << lod.value(), steepest_fx);
    }
  }
}

/// Over the region and `ring` columns around it.
void Generator::crop_share(std::size_t rule, int ring, Field& share) const {
  const Scratch& s = *scratch_;
  const Field& all = s.ground.shares()[rule];
  if (!all.values.empty()) return all.crop_into(s.around - ring, share);
  share.reshape(s.region.width + 2 * ring, s.region.depth + 2 * ring);
  std::fill(share.values.begin(), share.values.end(), 0);
}

/// Takes the results that are known with the ground.
void Generator::take_places(Terrain& terrain) {
  Scratch& s = *scratch_;
  s.ground.bare().crop_into(s.around + s.ground.bare_ring(), terrain.bare);
  shift_right(terrain.bare, terrain.region.lod.value());
  take_looks(terrain.looks);
  start_objects(terrain.objects);
  while (step_objects(kColumnsAPiece, terrain.objects)) {
  }
  terrain.place.resize(world_->loose().size());
  for (std::size_t m = 0; m < terrain.place.size(); ++m) {
    const LooseSpec& loose = world_->loose()[m];
    Field& place = terrain.place[m];
    place.reshape(terrain.region.width, terrain.region.depth);
    std::fill(place.values.begin(), place.values.end(), kWholeShare);
    if (loose.share) crop_share(*loose.share, 0, place);
    for (std::int32_t& value : place.values) value = loose.thickness_at(terrain.region.lod, value);
  }
}

void Generator::start_objects(std::vector<PlacedObject>& objects) {
  Scratch& s = *scratch_;
  objects.clear();
  s.standing = nullptr;
  s.placement.kind = 0;
  s.placement.row = 0;
  s.placement.seen_in.clear();
  for (const auto& feature : world_->features()) {
    if (feature->stands()) s.standing = feature.get();
  }
}

bool Generator::step_objects(int columns, std::vector<PlacedObject>& objects) {
  Scratch& s = *scratch_;
  if (s.standing == nullptr) return false;
  StandingGround ground{s.region, s.around,    &s.ground.height(), s.ground.places(),
                        nullptr,  s.open_ring, world_->sea_fx()};
  if (s.carver && !s.carver->entrances().values.empty()) ground.entrances = &s.carver->entrances();
  return s.standing->place(ground, columns, s.placement, objects);
}

void Generator::take_looks(std::vector<LookField>& looks) {
  const Scratch& s = *scratch_;
  looks.resize(s.ground.looks().size());
  for (std::size_t i = 0; i < looks.size(); ++i) s.ground.looks()[i].crop_into(s.around, looks[i]);
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
