#include "surface/regions/region_rows.h"

#include <algorithm>

#include <talus/vectors/tables.h>

#include "noise/lattice_place.h"

namespace talus::terrain {
namespace {

std::int64_t cell_of(std::int64_t column) {
  return floor_div(column, kSampleStep) * kSampleStep;
}

/// The distance between neighbours, where it is the same everywhere and a sample's cell has a whole number of
/// them; else 0.
std::int64_t step_of(std::span<const std::int64_t> xs) {
  if (xs.size() < 2) return 0;
  const std::int64_t step = xs[1] - xs[0];
  if (step < 1 || kSampleStep % step != 0 || floor_mod(xs[0], step) != 0) return 0;
  for (std::size_t i = 1; i < xs.size(); ++i) {
    if (xs[i] - xs[i - 1] != step) return 0;
  }
  return step;
}

}  // namespace

RegionRows::RegionRows(const Surface& surface, InstructionSet set)
    : regions_{surface.regions},
      places_{surface.places},
      highest_fx_{surface.highest_fx},
      kernels_{&region_kernels(set)},
      place_kernels_{&place_kernels(set)},
      lines_{regions_->slow, regions_->shape, set},
      shape_{set},
      border_{set},
      spread_(kSlowCount + regions_->slow.others.size()),
      at_columns_(spread_.size()) {}

void RegionRows::start(std::span<const std::int64_t> xs) {
  begin(xs, false);
}

bool RegionRows::starts_level(std::span<const std::int64_t> xs, Lod lod) {
  begin(xs, true);
  // Two columns wide at least, so that no diagonal breaks it.
  widened_ = static_cast<float>(std::int64_t{1} << lod.value()) * regions_->slow.units_a_column;
  return true;
}

void RegionRows::begin(std::span<const std::int64_t> xs, bool sloped) {
  width_ = xs.size();
  sloped_ = sloped;
  lay_out(xs);
  lines_.start(samples_, sloped);
  shape_.start(regions_->shape, xs);
  if (places_) border_.start(regions_->border, xs);
  const std::size_t spread_width = padded(columns_a_cell_ == 0 ? width_ : samples_.size() * columns_a_cell_);
  const auto resize = [&](std::vector<AlignedVector<float>>& rows, std::vector<float*>& at) {
    at.resize(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].resize(spread_width);
      at[i] = rows[i].data() + skipped_;
    }
  };
  resize(spread_, at_columns_);
  for (auto& octave : octaves_) octave.resize(padded(width_));
  blended_.resize(padded(samples_.size()));
  heights_.resize(padded(width_));
  if (places_) {
    for (auto& detail : details_) detail.resize(padded(width_));
  }
  if (!sloped) return;
  for (std::size_t axis = 0; axis < rises_.size(); ++axis) {
    rises_[axis].resize(kSlowCount);
    resize(rises_[axis], rises_at_columns_[axis]);
    for (auto& octave : octave_rises_[axis]) octave.resize(padded(width_));
  }
  slopes_.resize(padded(width_));
}

void RegionRows::lay_out(std::span<const std::int64_t> xs) {
  samples_.clear();
  offsets_.clear();
  skipped_ = 0;
  const std::int64_t step = step_of(xs);
  columns_a_cell_ = step == 0 ? 0 : static_cast<std::size_t>(kSampleStep / step);
  at_samples_ =
      std::all_of(xs.begin(), xs.end(), [](std::int64_t x) { return floor_mod(x, kSampleStep) == 0; });
  if (step != 0) {
    for (std::int64_t x = cell_of(xs.front()); x <= cell_of(xs.back()) + kSampleStep; x += kSampleStep) {
      samples_.push_back(x);
    }
    skipped_ = static_cast<std::size_t>((xs.front() - samples_.front()) / step);
    for (std::size_t k = 0; k < columns_a_cell_; ++k) {
      fractions_[k] =
          static_cast<float>(static_cast<std::int64_t>(k) * step) / static_cast<float>(kSampleStep);
    }
    return;
  }
  for (const std::int64_t x : xs) {
    samples_.push_back(cell_of(x));
    if (floor_mod(x, kSampleStep) != 0) samples_.push_back(cell_of(x) + kSampleStep);
  }
  std::sort(samples_.begin(), samples_.end());
  samples_.erase(std::unique(samples_.begin(), samples_.end()), samples_.end());
  for (const std::int64_t x : xs) {
    const auto west = static_cast<std::size_t>(
        std::lower_bound(samples_.begin(), samples_.end(), cell_of(x)) - samples_.begin());
    const std::int64_t inside = floor_mod(x, kSampleStep);
    offsets_.push_back(
        {west, inside == 0 ? west : west + 1, static_cast<float>(inside) / static_cast<float>(kSampleStep)});
  }
}

void RegionRows::spread(const float* samples, float* out) {
  if (at_samples_) {
    std::copy_n(samples, width_, out);
    return;
  }
  if (columns_a_cell_ != 0) {
    return kernels_->spread(samples, samples_.size() - 1, columns_a_cell_, fractions_.data(), out);
  }
  for (std::size_t i = 0; i < offsets_.size(); ++i) {
    const Offset& at = offsets_[i];
    out[i] = samples[at.west] + (samples[at.east] - samples[at.west]) * at.fraction;
  }
}

/// The first `count` of the slow rows, at the columns of row z.
void RegionRows::spread_row(std::int64_t z, const SlowLine SlopedLine::*rows, std::size_t count,
                            std::vector<AlignedVector<float>>& out) {
  const std::int64_t north_z = cell_of(z);
  const auto fraction = static_cast<float>(z - north_z) / static_cast<float>(kSampleStep);
  const SlowLine& north = lines_.at(north_z).*rows;
  if (z == north_z) {
    for (std::size_t slow = 0; slow < count; ++slow) spread(north[slow].data(), out[slow].data());
    return;
  }
  const SlowLine& south = lines_.at(north_z + kSampleStep).*rows;
  for (std::size_t slow = 0; slow < count; ++slow) {
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      blended_[i] = north[slow][i] + (south[slow][i] - north[slow][i]) * fraction;
    }
    spread(blended_.data(), out[slow].data());
  }
}

RegionRow RegionRows::row_of(const std::vector<float*>& at) const {
  const auto slow = [&](Slow of) { return at[static_cast<std::size_t>(of)]; };
  RegionRow row{slow(Slow::base),        slow(Slow::belt),        slow(Slow::hills),
                slow(Slow::mesa),        slow(Slow::terrace),     slow(Slow::river),
                slow(Slow::tributary_a), slow(Slow::tributary_b), {}};
  for (std::size_t k = 0; k < static_cast<std::size_t>(kSlowOctaves); ++k) {
    row.shape[k] = at[static_cast<std::size_t>(Slow::shape_0) + k];
  }
  return row;
}

void RegionRows::row(std::int64_t z, std::int32_t* heights_fx) {
  spread_row(z, &SlopedLine::values, spread_.size(), spread_);
  RegionRow at = row_of(at_columns_);
  for (std::size_t k = kSlowOctaves; k < kShapeOctaves; ++k) {
    shape_.octave(static_cast<int>(k), z, {octaves_[k].data()});
    at.shape[k] = octaves_[k].data();
  }
  const RegionDetails details =
      places_ ? RegionDetails{details_[0].data(), details_[1].data(), details_[2].data()} : RegionDetails{};
  kernels_->compose(at, regions_->at_columns, width_, highest_fx_, heights_.data(), details);
  std::copy_n(heights_.begin(), width_, heights_fx);
}

void RegionRows::sloped_row(std::int64_t z, std::int32_t* heights_fx, std::int32_t* slopes_fx) {
  spread_row(z, &SlopedLine::values, spread_.size(), spread_);
  spread_row(z, &SlopedLine::east, kSlowCount, rises_[0]);
  spread_row(z, &SlopedLine::south, kSlowCount, rises_[1]);
  SlopedRegionRow at{row_of(at_columns_), row_of(rises_at_columns_[0]), row_of(rises_at_columns_[1])};
  for (std::size_t k = kSlowOctaves; k < kShapeOctaves; ++k) {
    shape_.octave(static_cast<int>(k), z,
                  {octaves_[k].data(), octave_rises_[0][k].data(), octave_rises_[1][k].data()});
    at.value.shape[k] = octaves_[k].data();
    at.east.shape[k] = octave_rises_[0][k].data();
    at.south.shape[k] = octave_rises_[1][k].data();
  }
  const RegionDetails details =
      places_ ? RegionDetails{details_[0].data(), details_[1].data(), details_[2].data()} : RegionDetails{};
  kernels_->compose_sloped(at, regions_->at_columns, widened_, width_, highest_fx_, heights_.data(),
                           slopes_.data(), details);
  std::copy_n(heights_.begin(), width_, heights_fx);
  std::copy_n(slopes_.begin(), width_, slopes_fx);
}

void RegionRows::quantities(std::int64_t z, std::span<const float*> rows) {
  const auto at = [&](Slow slow) { return at_columns_[static_cast<std::size_t>(slow)]; };
  const float* const border = border_.row(z);
  const PlaceKernels& kernels = *place_kernels_;
  kernels.climate({border, details_[2].data(), details_[0].data()}, places_->reciprocal_lapse, width_,
                  at(Slow::temperature), at(Slow::moisture));
  constexpr float kJitter = 0.047F;            // as of climate
  constexpr float kBaseJitter = 20 * kJitter;  // of heights
  kernels.jitter(border, kJitter, width_, at(Slow::mesa));
  kernels.jitter(border, kJitter, width_, at(Slow::belt));
  kernels.jitter(border, kBaseJitter, width_, at(Slow::base));
  kernels.jitter(border, kJitter, width_, details_[1].data());
  const auto set = [&](Quantity quantity, const float* values) { rows[number_of(quantity)] = values; };
  set(Quantity::height, details_[0].data());
  set(Quantity::temperature, at(Slow::temperature));
  set(Quantity::moisture, at(Slow::moisture));
  set(Quantity::mesas, at(Slow::mesa));
  set(Quantity::ranges, at(Slow::belt));
  set(Quantity::base, at(Slow::base));
  set(Quantity::terraces, details_[1].data());
  for (std::size_t i = 0; i < regions_->slow.others.size(); ++i) {
    kernels.jitter(border, kJitter, width_, at_columns_[kSlowCount + i]);
    rows[kQuantities + i] = at_columns_[kSlowCount + i];
  }
}

}  // namespace talus::terrain
