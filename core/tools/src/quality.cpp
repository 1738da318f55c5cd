#include "quality.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <optional>

#include <talus/terrain/boundary_row.h>
#include <talus/terrain/slope.h>

#include <talus/map/column_grid.h>
#include "ordered_work.h"
#include "spread.h"
#include "water_pieces.h"

namespace talus::tools {
namespace {

constexpr std::array kBandsFrom{16, 32, 64, 128, 256, 512};
constexpr int kSamplesAWave = 8;  // of a band's shortest
constexpr std::int64_t kReach = std::int64_t{1} << 24;
constexpr double kEvenWithin = 0.1;
constexpr double kErrors = 2.5;
constexpr double kWaterDeviation = 0.25;
constexpr int kKinds = 8;
constexpr double kLoneWater = 0.01;

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

struct Extreme {
  std::int32_t fx = 0;
  std::int64_t x = 0;
  std::int64_t z = 0;
};

// What one place gives; parts of it are empty, by its kind.
struct PlaceResult {
  enum class Kind : std::uint8_t { spectrum, block, window };
  Kind kind = Kind::spectrum;
  std::size_t band = 0;
  std::optional<BandPower> power;
  std::vector<std::int64_t> by_look;  // columns of land
  std::int64_t columns = 0;
  std::int64_t water = 0;
  WaterPieces pieces;
  Extreme step;
  std::array<std::int64_t, kSlopeDegrees.size()> steep{};
  Extreme highest{INT32_MIN};
  Extreme deepest{INT32_MAX};
};

class Places {
 public:
  Places(const terrain::World& world, const QualityOptions& options) : world_{world}, options_{options} {}

  [[nodiscard]] std::size_t count() const {
    return spectra() + static_cast<std::size_t>(options_.blocks) + static_cast<std::size_t>(options_.windows);
  }
  [[nodiscard]] std::uint64_t columns() const {
    const auto block = static_cast<std::uint64_t>(kBlockSide / kBlockEvery);
    const auto side = static_cast<std::uint64_t>(options_.window_side);
    return spectra() * kSpectrumSide * kSpectrumSide +
           static_cast<std::uint64_t>(options_.blocks) * block * block +
           static_cast<std::uint64_t>(options_.windows) * side * side;
  }

  [[nodiscard]] PlaceResult look_at(std::size_t index) const {
    if (index < spectra()) return spectrum(index % kBandsFrom.size(), index / kBandsFrom.size());
    index -= spectra();
    const auto blocks = static_cast<std::size_t>(options_.blocks);
    return index < blocks ? block(index) : window(index - blocks);
  }

 private:
  [[nodiscard]] std::size_t spectra() const {
    return kBandsFrom.size() * static_cast<std::size_t>(options_.spectra);
  }
  [[nodiscard]] bool is_wet(std::int32_t height_fx) const {
    return world_.sea_fx() && terrain::boundary_row(height_fx) < terrain::boundary_row(*world_.sea_fx());
  }

  static void note_extremes(const map::ColumnGrid& grid, const terrain::Field& heights_fx,
                            PlaceResult& result) {
    result.columns = static_cast<std::int64_t>(grid.columns());
    for (int k = 0; k < grid.depth; ++k) {
      for (int i = 0; i < grid.width; ++i) {
        const std::int32_t fx = heights_fx.at(i, k);
        if (fx > result.highest.fx) result.highest = {fx, grid.x_of(i), grid.z_of(k)};
        if (fx < result.deepest.fx) result.deepest = {fx, grid.x_of(i), grid.z_of(k)};
      }
    }
  }

  [[nodiscard]] PlaceResult spectrum(std::size_t band, std::size_t index) const {
    const map::ColumnGrid grid =
        grid_at_random(1 + band, index, kBandsFrom[band] / kSamplesAWave, kSpectrumSide);
    const terrain::Field heights_fx = map::sample_columns(world_, grid).heights_fx;
    PlaceResult result;
    result.band = band;
    result.power = band_power(std::vector<double>(heights_fx.values.begin(), heights_fx.values.end()));
    note_extremes(grid, heights_fx, result);
    return result;
  }

  [[nodiscard]] PlaceResult block(std::size_t index) const {
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

  // Slopes need a ring around the window; the rest does without.
  [[nodiscard]] PlaceResult window(std::size_t index) const {
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
      limits[d] = static_cast<std::int32_t>(terrain::kSubvoxels *
                                            std::tan(kSlopeDegrees[d] * std::numbers::pi / 180));
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
    return result;
  }

  const terrain::World& world_;
  const QualityOptions& options_;
};

class Tally {
 public:
  Tally(const terrain::World& world, const QualityOptions& options)
      : world_{world}, by_kind_(world.look_names().size() + 1), dominated_(by_kind_.size()) {
    quality_.options = options;
  }

  void add(const PlaceResult& place) {
    if (place.power) powers_[place.band].push_back(*place.power);
    if (place.kind == PlaceResult::Kind::block) add_block(place);
    if (place.kind == PlaceResult::Kind::window) add_window(place);
    if (place.highest.fx > highest_.fx) highest_ = place.highest;
    if (place.deepest.fx < deepest_.fx) deepest_ = place.deepest;
  }

  Quality take() {
    for (std::size_t b = 0; b < kBandsFrom.size(); ++b) {
      quality_.bands.push_back({kBandsFrom[b], 2 * kBandsFrom[b], ratio_of(powers_[b])});
    }
    take_blocks();
    take_windows();
    const std::int32_t sea_fx = world_.sea_fx().value_or(0);
    quality_.highest = place_of(highest_, sea_fx);
    quality_.deepest = place_of(deepest_, sea_fx);
    judge();
    return std::move(quality_);
  }

 private:
  static QualityPlace place_of(const Extreme& extreme, std::int32_t zero_fx) {
    return {static_cast<double>(extreme.fx - zero_fx) / terrain::kSubvoxels, extreme.x, extreme.z};
  }

  void add_block(const PlaceResult& place) {
    std::vector<std::int64_t> columns = place.by_look;
    columns.push_back(place.water);  // the last kind
    for (std::size_t kind = 0; kind < columns.size(); ++kind) by_kind_[kind] += columns[kind];
    ++dominated_[static_cast<std::size_t>(std::max_element(columns.begin(), columns.end()) -
                                          columns.begin())];
    water_shares_.push_back(static_cast<double>(place.water) / static_cast<double>(place.columns));
  }

  void add_window(const PlaceResult& place) {
    window_columns_ += place.columns;
    pieces_.water += place.pieces.water;
    pieces_.lone += place.pieces.lone;
    pieces_.inland += place.pieces.inland;
    for (std::size_t d = 0; d < steep_.size(); ++d) steep_[d] += place.steep[d];
    if (place.step.fx > step_.fx) step_ = place.step;
  }

  void take_blocks() {
    const Spread spread = spread_of(water_shares_);
    quality_.water_mean = spread.mean;
    quality_.water_deviation = spread.deviation;
    std::sort(water_shares_.begin(), water_shares_.end());
    const std::size_t last = water_shares_.size() - 1;
    quality_.water_percentiles = {water_shares_.front(), water_shares_[last / 10], water_shares_[last / 2],
                                  water_shares_[last * 9 / 10], water_shares_.back()};
    std::int64_t all = 0;
    for (const std::int64_t columns : by_kind_) all += columns;
    for (std::size_t kind = 0; kind < by_kind_.size(); ++kind) {
      if (by_kind_[kind] == 0) continue;
      const bool ground = kind + 1 < by_kind_.size();
      std::string name = ground ? world_.look_names()[kind] : "water";
      if (name.empty()) name = world_.look_names().size() > 1 ? "no look" : "ground";
      quality_.kinds.push_back(
          {name, ground, dominated_[kind], static_cast<double>(by_kind_[kind]) / static_cast<double>(all)});
      if (ground && dominated_[kind] > 0) ++quality_.kinds_somewhere;
    }
    std::stable_sort(quality_.kinds.begin(), quality_.kinds.end(), [](const auto& a, const auto& b) {
      return a.blocks != b.blocks ? a.blocks > b.blocks : a.share > b.share;
    });
  }

  void take_windows() {
    const auto share = [](std::int64_t part, std::int64_t whole) {
      return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
    };
    quality_.window_water = share(pieces_.water, window_columns_);
    quality_.lone_water = share(pieces_.lone, pieces_.water);
    quality_.inland_water = share(pieces_.inland, pieces_.water);
    for (std::size_t d = 0; d < steep_.size(); ++d) {
      quality_.steep[d] = share(steep_[d], window_columns_ - pieces_.water);
    }
    quality_.largest_step = place_of(step_, 0);
  }

  template <typename... Numbers>
  void wish(const char* what, bool met, const char* format, Numbers... numbers) {
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), format, numbers...);
    quality_.wishes.push_back({what, text.data(), met});
  }

  void judge() {
    double farthest = 0;
    bool even = true;
    for (const QualityBand& band : quality_.bands) {
      const double off = std::abs(band.power.ratio - 1);
      if (band.power.windows < 2) continue;
      farthest = std::max(farthest, off);
      even = even && (off <= kEvenWithin || off <= kErrors * band.power.error);
    }
    wish("power along axes : diagonals within 10 % of 1, or 2.5 standard errors, in every band", even,
         "%.1f %% at most", 100 * farthest);
    wish("water: standard deviation of the blocks' shares at least 25 points",
         quality_.water_deviation >= kWaterDeviation, "%.1f points", 100 * quality_.water_deviation);
    wish("at least 8 kinds of ground cover most of some block", quality_.kinds_somewhere >= kKinds,
         "%d kinds", quality_.kinds_somewhere);
    wish("less than 1 % of water in lone pieces", quality_.lone_water < kLoneWater, "%.3f %%",
         100 * quality_.lone_water);
  }

  const terrain::World& world_;
  Quality quality_;
  std::array<std::vector<BandPower>, kBandsFrom.size()> powers_;
  std::vector<double> water_shares_;
  std::vector<std::int64_t> by_kind_;  // columns by look, then water
  std::vector<int> dominated_;
  std::int64_t window_columns_ = 0;
  WaterPieces pieces_;
  std::array<std::int64_t, kSlopeDegrees.size()> steep_{};
  Extreme step_;
  Extreme highest_{INT32_MIN};
  Extreme deepest_{INT32_MAX};
};

}  // namespace

QualityOptions QualityOptions::quick(int threads) {
  return {.threads = threads, .spectra = 24, .blocks = 20, .windows = 6, .window_side = 512};
}

Quality measure_quality(const terrain::World& world, const QualityOptions& options, ProgressBar& progress) {
  const Places places{world, options};
  Tally tally{world, options};
  progress.expect(places.columns());
  work_in_order(
      places.count(), thread_count(options.threads), [&](std::size_t index) { return places.look_at(index); },
      [&](std::size_t, const PlaceResult& place) {
        tally.add(place);
        progress.advance(static_cast<std::uint64_t>(place.columns));
        return true;
      });
  return tally.take();
}

}  // namespace talus::tools
