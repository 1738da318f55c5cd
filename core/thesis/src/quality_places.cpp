#include "quality_places.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include <talus/terrain/boundary_row.h>
#include <talus/terrain/places.h>
#include <talus/terrain/slope.h>

namespace talus::tools {
namespace {

constexpr int kSamplesAWave = 8;  // per shortest wave of a band
constexpr std::int64_t kReach = std::int64_t{1} << 24;
constexpr int kBatch = 500;                                     // places of a lattice per batch
constexpr std::int32_t kBedIsADepth = terrain::kSubvoxels / 2;  // a shallower one is a hollow

// SplitMix64 (Steele, Lea, Flood 2014).
std::uint64_t mixed(std::uint64_t state) {
  state += 0x9E3779B97F4A7C15U;
  state = (state ^ (state >> 30U)) * 0xBF58476D1CE4E5B9U;
  state = (state ^ (state >> 27U)) * 0x94D049BB133111EBU;
  return state ^ (state >> 31U);
}

std::int64_t coordinate(std::uint64_t purpose, std::uint64_t index, std::uint64_t axis) {
  return static_cast<std::int64_t>(mixed(mixed(purpose * 2 + axis) + index) % (2 * kReach)) - kReach;
}

map::ColumnGrid grid_at_random(std::uint64_t purpose, std::size_t index, std::int64_t every, int side) {
  return {coordinate(purpose, index, 0), coordinate(purpose, index, 1), every, side, side};
}

void note_extremes(const map::ColumnGrid& grid, const terrain::Field& heights_fx, PlaceResult& result) {
  result.columns = static_cast<std::int64_t>(grid.columns());
  for (int k = 0; k < grid.depth; ++k) {
    for (int i = 0; i < grid.width; ++i) {
      const std::int32_t fx = heights_fx.at(i, k);
      if (fx > result.highest.fx) result.highest = {fx, grid.x_of(i), grid.z_of(k)};
      if (fx < result.deepest.fx) result.deepest = {fx, grid.x_of(i), grid.z_of(k)};
    }
  }
}

std::int32_t subvoxels(float units, const terrain::World& world) {
  return static_cast<std::int32_t>(units * static_cast<float>(world.spec().resolution * terrain::kSubvoxels));
}

}  // namespace

void Moments::add(double value) {
  count += 1;
  sum += value;
  squares += value * value;
}

void Moments::add(const Moments& more) {
  count += more.count;
  sum += more.sum;
  squares += more.squares;
}

double Moments::variance() const {
  return count == 0 ? 0 : std::max(0.0, squares / count - mean() * mean());
}

QualityPlaces::QualityPlaces(const terrain::World& world, const QualityOptions& options)
    : world_{world}, options_{options}, lattices_{terrain::ShapingLattices::make(world)} {}

std::vector<std::string> QualityPlaces::lattices() const {
  return lattices_ ? lattices_->names() : std::vector<std::string>{};
}

std::size_t QualityPlaces::spectra() const {
  return kBandsFrom.size() * static_cast<std::size_t>(options_.spectra);
}

std::size_t QualityPlaces::batches() const {
  return static_cast<std::size_t>((options_.lattice_places + kBatch - 1) / kBatch);
}

std::size_t QualityPlaces::count() const {
  return spectra() + static_cast<std::size_t>(options_.blocks) + static_cast<std::size_t>(options_.windows) +
         lattices().size() * batches();
}

std::uint64_t QualityPlaces::columns() const {
  const auto block = static_cast<std::uint64_t>(kBlockSide / kBlockEvery);
  const auto side = static_cast<std::uint64_t>(options_.window_side);
  return spectra() * kSpectrumSide * kSpectrumSide +
         static_cast<std::uint64_t>(options_.blocks) * block * block +
         static_cast<std::uint64_t>(options_.windows) * side * side +
         lattices().size() * static_cast<std::uint64_t>(options_.lattice_places) * 2;
}

PlaceResult QualityPlaces::measure(std::size_t index) const {
  if (index < spectra()) return spectrum(index % kBandsFrom.size(), index / kBandsFrom.size());
  index -= spectra();
  const auto blocks = static_cast<std::size_t>(options_.blocks);
  if (index < blocks) return block(index);
  index -= blocks;
  const auto windows = static_cast<std::size_t>(options_.windows);
  if (index < windows) return window(index);
  index -= windows;
  return lattice(index / batches(), index % batches());
}

bool QualityPlaces::is_wet(std::int32_t height_fx) const {
  return world_.sea_fx() && terrain::boundary_row(height_fx) < terrain::boundary_row(*world_.sea_fx());
}

PlaceResult QualityPlaces::spectrum(std::size_t band, std::size_t index) const {
  const map::ColumnGrid grid =
      grid_at_random(1 + band, index, kBandsFrom[band] / kSamplesAWave, kSpectrumSide);
  const terrain::Field heights_fx = map::sample_columns(world_, grid).heights_fx;
  PlaceResult result;
  result.of = band;
  result.power = band_power(std::vector<double>(heights_fx.values.begin(), heights_fx.values.end()));
  note_extremes(grid, heights_fx, result);
  return result;
}

PlaceResult QualityPlaces::block(std::size_t index) const {
  const map::ColumnGrid grid = grid_at_random(100, index, kBlockEvery, kBlockSide / kBlockEvery);
  const map::ColumnSamples samples = map::sample_columns(world_, grid);
  PlaceResult result;
  result.kind = PlaceResult::Kind::block;
  result.by_look.resize(world_.look_names().size());
  for (std::size_t i = 0; i < samples.looks.values.size(); ++i) {
    const bool wet = is_wet(samples.heights_fx.values[i]);
    ++(wet ? result.water : result.by_look[samples.looks.values[i]]);
  }
  note_extremes(grid, samples.heights_fx, result);
  return result;
}

// Slopes need a ring around the window; other numbers do not.
PlaceResult QualityPlaces::window(std::size_t index) const {
  const int side = options_.window_side;
  const map::ColumnGrid grid = grid_at_random(200, index, 1, side);
  const terrain::Field ringed = map::sample_columns(world_, grid.expanded(1)).heights_fx;
  const terrain::Field slope = slope_inside(ringed);
  const terrain::Field heights_fx = ringed.cropped(1);
  PlaceResult result;
  result.kind = PlaceResult::Kind::window;
  note_extremes(grid, heights_fx, result);
  std::vector<std::uint8_t> wet(grid.columns());
  std::array<std::int32_t, kSlopeDegrees.size()> limits{};
  for (std::size_t d = 0; d < limits.size(); ++d) {
    limits[d] =
        static_cast<std::int32_t>(terrain::kSubvoxels * std::tan(kSlopeDegrees[d] * std::numbers::pi / 180));
  }
  for (int z = 0; z < side; ++z) {
    for (int x = 0; x < side; ++x) {
      const std::int32_t here = heights_fx.at(x, z);
      const bool is_water = is_wet(here);
      wet[static_cast<std::size_t>(z * side + x)] = is_water ? 1 : 0;
      const std::int32_t step =
          std::max(std::abs(ringed.at(x + 2, z + 1) - here), std::abs(ringed.at(x + 1, z + 2) - here));
      if (step > result.step.fx) result.step = {step, grid.x_of(x), grid.z_of(z)};
      for (std::size_t d = 0; d < limits.size() && !is_water; ++d) {
        result.steep[d] += slope.at(x, z) > limits[d] ? 1 : 0;
      }
    }
  }
  result.pieces = water_pieces(wet, side, side);
  measure_parts(grid, result);
  return result;
}

// Takes a lattice point and a cell centre near each place, so that they differ in little else.
PlaceResult QualityPlaces::lattice(std::size_t noise, std::size_t batch) const {
  PlaceResult result;
  result.kind = PlaceResult::Kind::lattice;
  result.of = noise;
  terrain::PlaceSampler sampler = terrain::PlaceSampler::make(world_, {}).value();
  const auto last =
      std::min<std::size_t>((batch + 1) * kBatch, static_cast<std::size_t>(options_.lattice_places));
  for (std::size_t i = batch * kBatch; i < last; ++i) {
    const auto sample = [&](terrain::ShapingLattices::Spot spot, Moments& heights) {
      const terrain::BaseColumn from{coordinate(300 + noise, i, 0), coordinate(300 + noise, i, 1)};
      const auto column = lattices_->column(noise, from, spot);
      ++result.columns;
      if (!column) return;
      sampler.start({&column->x, 1});
      sampler.row(column->z);
      heights.add(static_cast<double>(sampler.heights_fx().front()) / terrain::kSubvoxels);
    };
    sample(terrain::ShapingLattices::Spot::point, result.at_points);
    sample(terrain::ShapingLattices::Spot::middle, result.at_middles);
  }
  return result;
}

// Measures river beds, and steps not made by terraces.
void QualityPlaces::measure_parts(const map::ColumnGrid& grid, PlaceResult& result) const {
  auto land = terrain::LandPartsSampler::make(world_);
  if (!land) return;
  std::vector<std::int64_t> xs(static_cast<std::size_t>(grid.width));
  for (std::size_t i = 0; i < xs.size(); ++i) xs[i] = grid.x_of(static_cast<int>(i));
  land->start(xs);
  std::vector<float> north;
  std::vector<float> here(xs.size());
  for (int k = 0; k < grid.depth; ++k) {
    land->row(grid.z_of(k));
    for (std::size_t i = 0; i < xs.size(); ++i) {
      here[i] = land->height()[i] - land->terraces()[i];
      const auto step = [&](float beside) {
        const std::int32_t fx = subvoxels(std::abs(here[i] - beside), world_);
        if (fx > result.other_step.fx) result.other_step = {fx, xs[i], grid.z_of(k)};
      };
      if (i > 0) step(here[i - 1]);
      if (k > 0) step(north[i]);
      if (subvoxels(land->bed()[i], world_) < kBedIsADepth) continue;
      const std::int32_t over = subvoxels(land->height()[i] - land->flood_plain()[i], world_);
      ++result.beds;
      const bool whole = land->river()[i] >= 1;
      if (!whole) ++result.fading_beds;
      PlaceResult::Extreme& highest = whole ? result.bed : result.fading_bed;
      if (over > highest.fx) highest = {over, xs[i], grid.z_of(k)};
    }
    north = here;
  }
}

}  // namespace talus::tools
