#include "quality.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include <talus/tools/ordered_work.h>

#include "quality_places.h"
#include "spread.h"

namespace talus::tools {
namespace {

constexpr double kEvenWithin = 0.1;
constexpr double kErrors = 2.5;
constexpr double kWaterDeviation = 0.25;
constexpr int kKinds = 8;
constexpr double kLoneWater = 0.01;
constexpr double kLatticeWithin = 0.05;  // standard deviations
constexpr double kStep = 15;             // voxels

class Tally {
 public:
  Tally(const terrain::World& world, const QualityOptions& options, const std::vector<std::string>& lattices)
      : world_{world},
        lattices_(lattices.size()),
        by_kind_(world.look_names().size() + 1),
        dominated_(by_kind_.size()) {
    quality_.options = options;
    quality_.regions = world.spec().surface.regions.has_value();
    for (const std::string& name : lattices) quality_.lattices.push_back({name});
  }

  void add(const PlaceResult& place) {
    if (place.power) powers_[place.of].push_back(*place.power);
    if (place.kind == PlaceResult::Kind::block) add_block(place);
    if (place.kind == PlaceResult::Kind::window) add_window(place);
    if (place.kind == PlaceResult::Kind::lattice) {
      lattices_[place.of].at_points.add(place.at_points);
      lattices_[place.of].at_middles.add(place.at_middles);
      return;
    }
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
    take_lattices(sea_fx);
    quality_.highest = place_of(highest_, sea_fx);
    quality_.deepest = place_of(deepest_, sea_fx);
    judge();
    return std::move(quality_);
  }

 private:
  static QualityPlace place_of(const PlaceResult::Extreme& extreme, std::int32_t zero_fx) {
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
    if (place.other_step.fx > other_step_.fx) other_step_ = place.other_step;
    beds_ += place.beds;
    fading_beds_ += place.fading_beds;
    if (place.bed.fx > bed_.fx) bed_ = place.bed;
    if (place.fading_bed.fx > fading_bed_.fx) fading_bed_ = place.fading_bed;
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
    quality_.other_step = place_of(other_step_, 0);
    quality_.beds = share(beds_, window_columns_);
    quality_.fading_beds = share(fading_beds_, beds_);
    if (beds_ > fading_beds_) quality_.highest_bed = place_of(bed_, 0);
    if (fading_beds_ > 0) quality_.highest_fading_bed = place_of(fading_bed_, 0);
  }

  void take_lattices(std::int32_t sea_fx) {
    const double sea = static_cast<double>(sea_fx) / terrain::kSubvoxels;
    for (std::size_t i = 0; i < lattices_.size(); ++i) {
      const Moments& points = lattices_[i].at_points;
      const Moments& middles = lattices_[i].at_middles;
      if (points.count == 0 || middles.count == 0) continue;
      Moments all = points;
      all.add(middles);
      const double deviation = std::sqrt(all.variance());
      QualityLattice& lattice = quality_.lattices[i];
      lattice.at_points = points.mean() - sea;
      lattice.at_middles = middles.mean() - sea;
      lattice.apart = deviation == 0 ? 0 : std::abs(points.mean() - middles.mean()) / deviation;
      lattice.error = std::sqrt(1 / points.count + 1 / middles.count);
    }
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
    if (!quality_.regions) {
      wish("no step between neighbours above 15 voxels", quality_.largest_step.voxels <= kStep, "%.1f voxels",
           quality_.largest_step.voxels);
      return;
    }
    wish("no step between neighbours above 15 voxels but on walls of terraces",
         quality_.other_step.voxels <= kStep, "%.1f voxels", quality_.other_step.voxels);
    double apart = 0;
    bool all_measured = true;
    for (std::size_t i = 0; i < lattices_.size(); ++i) {
      apart = std::max(apart, quality_.lattices[i].apart);
      all_measured = all_measured && lattices_[i].at_points.count > 0 && lattices_[i].at_middles.count > 0;
    }
    wish("heights at lattice points within 0.05 standard deviations of those at middles of cells",
         all_measured && apart <= kLatticeWithin, all_measured ? "%.3f at most" : "not measured everywhere",
         apart);
    const bool any_whole = beds_ > fading_beds_;
    wish("no bed of a whole river above its flood plain, 1.2 over the sea and more in high land",
         any_whole && quality_.highest_bed.voxels <= 0, any_whole ? "%.2f voxels at most" : "none found",
         quality_.highest_bed.voxels);
  }

  struct LatticeHeights {
    Moments at_points;
    Moments at_middles;
  };

  const terrain::World& world_;
  Quality quality_;
  std::vector<LatticeHeights> lattices_;
  std::array<std::vector<BandPower>, kBandsFrom.size()> powers_;
  std::vector<double> water_shares_;
  std::vector<std::int64_t> by_kind_;  // columns by look, then water
  std::vector<int> dominated_;
  std::int64_t window_columns_ = 0;
  WaterPieces pieces_;
  std::array<std::int64_t, kSlopeDegrees.size()> steep_{};
  PlaceResult::Extreme step_;
  PlaceResult::Extreme other_step_;
  PlaceResult::Extreme bed_{INT32_MIN};
  PlaceResult::Extreme fading_bed_{INT32_MIN};
  std::int64_t beds_ = 0;
  std::int64_t fading_beds_ = 0;
  PlaceResult::Extreme highest_{INT32_MIN};
  PlaceResult::Extreme deepest_{INT32_MAX};
};

}  // namespace

QualityOptions QualityOptions::quick(int threads) {
  return {.threads = threads,
          .spectra = 24,
          .blocks = 20,
          .windows = 6,
          .window_side = 512,
          .lattice_places = 4'000};
}

Quality measure_quality(const terrain::World& world, const QualityOptions& options, ProgressBar& progress) {
  const QualityPlaces places{world, options};
  Tally tally{world, options, places.lattices()};
  progress.expect(places.columns());
  work_in_order(
      places.count(), thread_count(options.threads), [&](std::size_t index) { return places.measure(index); },
      [&](std::size_t, const PlaceResult& place) {
        tally.add(place);
        progress.advance(static_cast<std::uint64_t>(place.columns));
        return true;
      });
  return tally.take();
}

}  // namespace talus::tools
