#include "surface/regions/region_rows.h"

#include <algorithm>

#include <talus/vectors/tables.h>

#include "noise/lattice_place.h"

namespace talus::terrain {
namespace {

/// Returns true if the land is shaped by the field. The rise of other fields is not computed.
bool shapes_land(std::size_t slow) {
  return slow < kSlowCount && slow != static_cast<std::size_t>(Slow::temperature) &&
         slow != static_cast<std::size_t>(Slow::moisture);
}

}  // namespace

RegionRows::RegionRows(const Surface& surface, InstructionSet set)
    : regions_{surface.regions},
      places_{surface.places},
      highest_fx_{surface.highest_fx},
      kernels_{&region_kernels(set)},
      place_kernels_{&place_kernels(set)},
      lines_{regions_->slow, regions_->shape, regions_->at_columns, set},
      shape_{set},
      border_{set},
      spread_(kSlowCount + regions_->slow.others.size()),
      at_columns_(spread_.size()) {}

void RegionRows::start(std::span<const std::int64_t> xs) {
  const auto is_sample = [](std::int64_t x) { return floor_mod(x, kSampleStep) == 0; };
  begin(xs, std::all_of(xs.begin(), xs.end(), is_sample), false);
}

bool RegionRows::starts_level(std::span<const std::int64_t> xs, Lod lod) {
  const std::int64_t step = std::int64_t{1} << lod.value();
  // Cubics between columns farther apart than that do not describe the ground next to a column.
  begin(xs, step > kSampleStep, true);
  // At least two columns wide, so that diagonal rivers are not interrupted.
  widened_ = static_cast<float>(step) * regions_->slow.units_a_column;
  return true;
}

void RegionRows::begin(std::span<const std::int64_t> xs, bool at_samples, bool sloped) {
  width_ = xs.size();
  sloped_ = sloped;
  at_samples_ = at_samples;
  between_.start(xs, at_samples);
  // Between samples the rise follows from the curves.
  lines_.start(between_.samples(), sloped && at_samples);
  from_cells_ = !sloped && between_.columns_a_cell() == static_cast<std::size_t>(kSampleStep);
  first_ = from_cells_ ? between_.first() : 0;
  if (first_ > 0) {
    // Extends to whole cells.
    whole_cells_.clear();
    for (std::int64_t x = xs.front() - static_cast<std::int64_t>(first_); x <= xs.back(); ++x) {
      whole_cells_.push_back(x);
    }
    xs = whole_cells_;
  }
  shape_.start(regions_->shape, xs);
  if (places_) border_.start(regions_->border, xs);
  if (from_cells_) start_cells();
  const auto resize = [&](std::vector<AlignedVector<float>>& rows, std::vector<float*>& at) {
    at.resize(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].resize(between_.row_size());
      at[i] = rows[i].data() + between_.first();
    }
  };
  resize(spread_, at_columns_);
  for (auto* const rows : {&blended_, &rising_}) {
    rows->resize(spread_.size());
    for (auto& values : *rows) values.resize(padded(between_.samples().size()));
  }
  for (auto& octave : octaves_) octave.resize(padded(xs.size()));
  heights_.resize(padded(xs.size()));
  if (places_) {
    for (auto& detail : details_) detail.resize(padded(xs.size()));
  }
  if (!sloped) return;
  for (std::size_t axis = 0; axis < rises_.size(); ++axis) {
    rises_[axis].resize(kSlowCount);
    resize(rises_[axis], rises_at_columns_[axis]);
    for (auto& octave : octave_rises_[axis]) octave.resize(padded(width_));
  }
  slopes_.resize(padded(width_));
}

void RegionRows::start_cells() {
  const std::size_t samples = between_.samples().size();
  rows_of_cells_ = {{}, {}, spread_.size(), samples, (samples + kMaxLanes - 1) / kMaxLanes * kMaxLanes};
  plane_of_cells_ = rows_of_cells_.count * rows_of_cells_.stride + kPadding;
  cubics_.resize(5 * plane_of_cells_);
  for (auto& line : sample_lines_) line.resize(spread_.size());
  lines_from_.reset();
  first_of_cells_.resize(spread_.size());
  for (std::size_t slow = 0; slow < first_of_cells_.size(); ++slow) {
    first_of_cells_[slow] = cubics_.data() + slow * rows_of_cells_.stride;
  }
}

/// Computes the polynomials between the samples of row z.
void RegionRows::find_cubics(std::int64_t z) {
  const std::int64_t inside = floor_mod(z, kSampleStep);
  const std::int64_t north = z - inside;
  const bool between = inside != 0;  // false: on a line
  if (!between || lines_from_ != north) {
    for (std::size_t k = 0; k < sample_lines_.size(); ++k) {
      const std::int64_t away = between ? (static_cast<std::int64_t>(k) - 1) * kSampleStep : 0;
      const SlowLine& line = lines_.at(north + away).values;
      for (std::size_t slow = 0; slow < line.size(); ++slow) sample_lines_[k][slow] = line[slow].data();
      rows_of_cells_.line[k] = sample_lines_[k].data();
    }
    lines_from_.reset();
    if (between) lines_from_ = north;
  }
  rows_of_cells_.share = line_shares(inside);
  kernels_->cubics(rows_of_cells_, plane_of_cells_, cubics_.data());
}

/// Computes the slow rows at the columns of row z, and if sloped their rise.
void RegionRows::spread_row(std::int64_t z) {
  if (sloped_ && at_samples_) return copy_sloped_line(z);
  blend_lines(z);
  const auto spread = [&](std::size_t slow) {
    const bool rises = sloped_ && shapes_land(slow);
    between_.row(*kernels_, blended_[slow].data(), spread_[slow].data(),
                 rises ? rises_[0][slow].data() : nullptr);
    if (rises) between_.row(*kernels_, rising_[slow].data(), rises_[1][slow].data(), nullptr);
  };
  const auto range = [&](Slow of) { return place_kernels_->range(slow(of), width_); };
  const auto is = [](std::size_t slow, Slow one) { return slow == static_cast<std::size_t>(one); };
  spread(static_cast<std::size_t>(Slow::mesa));
  spread(static_cast<std::size_t>(Slow::river));
  // No column reads the field of terraces outside of mesa country, or tributaries on the other side of the
  // river: these rows keep their old values.
  const bool no_mesas = range(Slow::mesa).high <= 0;
  const ValueRange river = range(Slow::river);
  for (std::size_t slow = 0; slow < spread_.size(); ++slow) {
    if (is(slow, Slow::mesa) || is(slow, Slow::river)) continue;
    if (is(slow, Slow::terrace) && no_mesas) continue;
    if (is(slow, Slow::tributary_a) && river.high <= 0) continue;
    if (is(slow, Slow::tributary_b) && river.low > 0) continue;
    spread(slow);
  }
}

/// Computes all slow rows at the samples of row z. Separate from its readers, which would wait for the
/// stores.
void RegionRows::blend_lines(std::int64_t z) {
  lines_from_.reset();  // lines_ may overwrite them
  const std::int64_t inside = floor_mod(z, kSampleStep);
  const bool on_line = inside == 0 && !sloped_;
  std::array<const SlowLine*, 4> lines{};
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const std::int64_t away = on_line ? 0 : (static_cast<std::int64_t>(k) - 1) * kSampleStep;
    lines[k] = &lines_.at(z - inside + away).values;
  }
  const std::array<float, 4> shares = line_shares(inside);
  const std::array<float, 4> rises = line_rises(inside);
  const std::size_t samples = between_.samples().size();
  for (std::size_t slow = 0; slow < spread_.size(); ++slow) {
    const auto line = [&](std::size_t k) { return (*lines[k])[slow].data(); };
    const std::array<const float*, 4> four{line(0), line(1), line(2), line(3)};
    kernels_->blend({four, shares}, samples, blended_[slow].data());
    if (sloped_ && shapes_land(slow)) kernels_->blend({four, rises}, samples, rising_[slow].data());
  }
}

/// REQUIRES that z is a multiple of kSampleStep.
void RegionRows::copy_sloped_line(std::int64_t z) {
  const SlopedLine& line = lines_.at(z);
  for (std::size_t slow = 0; slow < spread_.size(); ++slow) {
    std::copy_n(line.values[slow].data(), width_, spread_[slow].data());
    if (!shapes_land(slow)) continue;
    std::copy_n(line.east[slow].data(), width_, rises_[0][slow].data());
    std::copy_n(line.south[slow].data(), width_, rises_[1][slow].data());
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

RegionRow RegionRows::plain_row(std::int64_t z) {
  spread_row(z);
  RegionRow at = row_of(at_columns_);
  for (std::size_t k = kSlowOctaves; k < kShapeOctaves; ++k) {
    shape_.octave(static_cast<int>(k), z, {octaves_[k].data()});
    at.shape[k] = octaves_[k].data() + first_;
  }
  return at;
}

RegionCells RegionRows::cells(std::int64_t z) {
  find_cubics(z);
  RegionCells cells{row_of(first_of_cells_), plane_of_cells_, between_.fractions()};
  for (std::size_t k = kSlowOctaves; k < kShapeOctaves; ++k) {
    shape_.octave(static_cast<int>(k), z, {octaves_[k].data()});
    cells.rows.shape[k] = octaves_[k].data();
  }
  return cells;
}

void RegionRows::parts_row(std::int64_t z, const LandParts& parts) {
  kernels_->part(plain_row(z), regions_->at_columns, width_, parts);
}

void RegionRows::row(std::int64_t z, std::int32_t* heights_fx) {
  RegionDetails details =
      places_ ? RegionDetails{details_[0].data(), details_[1].data(), details_[2].data()} : RegionDetails{};
  if (from_cells_) {
    const RegionCells from = cells(z);
    if (places_) {
      const auto whole_row = [&](Slow slow) { return spread_[static_cast<std::size_t>(slow)].data(); };
      details.base = whole_row(Slow::base);
      details.belt = whole_row(Slow::belt);
      details.mesa = whole_row(Slow::mesa);
      spread_climate();
    }
    kernels_->compose_cells(from, regions_->at_columns, first_ + width_, highest_fx_, heights_.data(),
                            details);
  } else {
    kernels_->compose(plain_row(z), regions_->at_columns, width_, highest_fx_, heights_.data(), details);
  }
  std::copy_n(heights_.data() + first_, width_, heights_fx);
}

/// Interpolates the fields that only places use, from the samples of the last row.
void RegionRows::spread_climate() {
  const float* const samples = cubics_.data() + 4 * plane_of_cells_;
  const auto spread = [&](std::size_t slow) {
    between_.row(*kernels_, samples + slow * rows_of_cells_.stride, spread_[slow].data(), nullptr);
  };
  spread(static_cast<std::size_t>(Slow::temperature));
  spread(static_cast<std::size_t>(Slow::moisture));
  for (std::size_t slow = kSlowCount; slow < spread_.size(); ++slow) spread(slow);
}

void RegionRows::sloped_row(std::int64_t z, std::int32_t* heights_fx, std::int32_t* slopes_fx) {
  spread_row(z);
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
  const float* const border = border_.row(z) + first_;
  float* const height = details_[0].data() + first_;
  float* const terraces = details_[1].data() + first_;
  const PlaceKernels& kernels = *place_kernels_;
  kernels.climate({border, details_[2].data() + first_, height}, places_->reciprocal_lapse, width_,
                  at(Slow::temperature), at(Slow::moisture));
  constexpr float kJitter = 0.047F;            // as in `climate`
  constexpr float kBaseJitter = 20 * kJitter;  // for heights
  kernels.jitter(border, kJitter, width_, at(Slow::mesa));
  kernels.jitter(border, kJitter, width_, at(Slow::belt));
  kernels.jitter(border, kBaseJitter, width_, at(Slow::base));
  kernels.jitter(border, kJitter, width_, terraces);
  const auto set = [&](Quantity quantity, const float* values) { rows[number_of(quantity)] = values; };
  set(Quantity::height, height);
  set(Quantity::temperature, at(Slow::temperature));
  set(Quantity::moisture, at(Slow::moisture));
  set(Quantity::mesas, at(Slow::mesa));
  set(Quantity::ranges, at(Slow::belt));
  set(Quantity::base, at(Slow::base));
  set(Quantity::terraces, terraces);
  for (std::size_t i = 0; i < regions_->slow.others.size(); ++i) {
    kernels.jitter(border, kJitter, width_, at_columns_[kSlowCount + i]);
    rows[kQuantities + i] = at_columns_[kSlowCount + i];
  }
}

}  // namespace talus::terrain
