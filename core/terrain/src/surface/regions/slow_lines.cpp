#include "surface/regions/slow_lines.h"

#include <algorithm>
#include <cmath>

#include <talus/vectors/tables.h>

#include "noise/lattice_place.h"

namespace talus::terrain {
namespace {

constexpr float kMaxDistance = 1000;  // terrain units: rivers are felt no further

template <typename Lines>
auto& slot_of(Lines& lines, std::int64_t z) {
  return lines[static_cast<std::size_t>(floor_mod(z / kSampleStep, static_cast<std::int64_t>(lines.size())))];
}

}  // namespace

SlowLines::SlowLines(const SlowFields& fields, const RotatedNoise& shape, InstructionSet set)
    : fields_{fields},
      kernels_{&region_kernels(set)},
      shape_noise_{shape},
      warp_at_samples_{set},
      warp_at_columns_{set},
      continents_{set},
      ranges_{set},
      hilliness_{set},
      mesas_{set},
      temperature_{set},
      moisture_{set},
      shape_{set},
      rivers_{RotatedFbm{set}, RotatedFbm{set}, RotatedFbm{set}} {}

void SlowLines::WarpNoise::start(const SlowFields& fields, std::span<const std::int64_t> columns) {
  east.start(fields.warp_east[0], columns);
  east_narrow.start(fields.warp_east[1], columns);
  south.start(fields.warp_south[0], columns);
  south_narrow.start(fields.warp_south[1], columns);
}

void SlowLines::start(std::span<const std::int64_t> samples) {
  samples_.assign(samples.begin(), samples.end());
  columns_.clear();
  for (const std::int64_t x : samples_)
    columns_.insert(columns_.end(), {x - kSampleStep, x, x + kSampleStep});
  std::sort(columns_.begin(), columns_.end());
  columns_.erase(std::unique(columns_.begin(), columns_.end()), columns_.end());
  beside_.clear();
  const auto place = [&](std::int64_t x) {
    return static_cast<std::size_t>(std::lower_bound(columns_.begin(), columns_.end(), x) - columns_.begin());
  };
  for (const std::int64_t x : samples_) {
    beside_.push_back({place(x - kSampleStep), place(x), place(x + kSampleStep)});
  }
  warp_at_samples_.start(fields_, samples_);
  warp_at_columns_.start(fields_, columns_);
  continents_.start(fields_.continents.noise, samples_);
  ranges_.start(fields_.ranges.noise, samples_);
  hilliness_.start(fields_.hilliness.noise, samples_);
  mesas_.start(fields_.mesas.noise, samples_);
  temperature_.start(fields_.temperature.noise, samples_);
  moisture_.start(fields_.moisture.noise, samples_);
  RotatedNoise slow_shape = shape_noise_;
  slow_shape.octaves = kSlowOctaves;
  shape_.start(slow_shape, samples_);
  for (std::size_t i = 0; i < rivers_.size(); ++i) rivers_[i].start(fields_.rivers[i], columns_);
  for (Line& line : lines_) {
    line.drawn = false;
    for (auto& values : line.values) values.resize(padded(samples_.size()));
  }
  for (RiverLine& line : river_lines_) line.drawn = false;
}

const SlowLine& SlowLines::at(std::int64_t z) {
  Line& line = slot_of(lines_, z);
  if (!line.drawn || line.z != z) {
    draw(z, line.values);
    line.z = z;
    line.drawn = true;
  }
  return line.values;
}

void SlowLines::warp(WarpNoise& noise, std::int64_t z, std::size_t width, WarpLine& line) const {
  const auto fill = [&](RotatedFbm& wide, RotatedFbm& narrow, std::vector<std::int32_t>& out) {
    out.resize(padded(width));
    kernels_->displace(wide.row(z), narrow.row(z), fields_.warp_reach, width, out.data());
  };
  fill(noise.east, noise.east_narrow, line.east);
  fill(noise.south, noise.south_narrow, line.south);
}

void SlowLines::draw(std::int64_t z, SlowLine& line) {
  warp(warp_at_samples_, z, samples_.size(), warp_);
  const Displacements warped{warp_.east.data(), warp_.south.data()};
  const SlowNoises noises{continents_.row(z, warped), ranges_.row(z, warped), hilliness_.row(z),
                          mesas_.row(z, warped),      temperature_.row(z),    moisture_.row(z)};
  const auto out = [&](Slow slow) { return line[static_cast<std::size_t>(slow)].data(); };
  kernels_->lay(noises, fields_, samples_.size(),
                {out(Slow::base), out(Slow::belt), out(Slow::hills), out(Slow::mesa), out(Slow::terrace),
                 out(Slow::temperature), out(Slow::moisture)});
  draw_shape(z, line);
  draw_rivers(z, line);
}

// By half the warp, so that hills and ridges bend with the land, and keep their size.
void SlowLines::draw_shape(std::int64_t z, SlowLine& line) {
  half_warp_.east.resize(warp_.east.size());
  half_warp_.south.resize(warp_.south.size());
  const auto half = [](std::int32_t distance) { return distance >> 1; };
  std::transform(warp_.east.begin(), warp_.east.end(), half_warp_.east.begin(), half);
  std::transform(warp_.south.begin(), warp_.south.end(), half_warp_.south.begin(), half);
  for (int k = 0; k < kSlowOctaves; ++k) {
    const float* const row = shape_.octave(k, z, {half_warp_.east.data(), half_warp_.south.data()});
    std::copy_n(row, samples_.size(),
                line[static_cast<std::size_t>(Slow::shape_0) + static_cast<std::size_t>(k)].begin());
  }
}

const SlowLines::RiverLine& SlowLines::rivers_at(std::int64_t z) {
  RiverLine& line = slot_of(river_lines_, z);
  if (line.drawn && line.z == z) return line;
  warp(warp_at_columns_, z, columns_.size(), river_warp_);
  for (std::size_t i = 0; i < rivers_.size(); ++i) {
    const float* const row = rivers_[i].row(z, {river_warp_.east.data(), river_warp_.south.data()});
    line.noise[i].assign(row, row + columns_.size());
  }
  line.z = z;
  line.drawn = true;
  return line;
}

// Where a noise is 0 runs a contour, without ends. Its value over its gradient is about the distance from
// there; kappa keeps that finite and continuous where the gradient is 0, at saddles and summits.
void SlowLines::draw_rivers(std::int64_t z, SlowLine& line) {
  const RiverLine& north = rivers_at(z - kSampleStep);
  const RiverLine& here = rivers_at(z);
  const RiverLine& south = rivers_at(z + kSampleStep);
  constexpr auto kSpan = static_cast<float>(2 * kSampleStep);
  for (std::size_t river = 0; river < rivers_.size(); ++river) {
    const float saddle = fields_.saddle[river == 0 ? 0 : 1];
    float* const distances = line[static_cast<std::size_t>(Slow::river) + river].data();
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const Beside& at = beside_[i];
      const float n = here.noise[river][at.here];
      const float gx = (here.noise[river][at.east] - here.noise[river][at.west]) / kSpan;
      const float gz = (south.noise[river][at.here] - north.noise[river][at.here]) / kSpan;
      const float columns = n / std::sqrt(gx * gx + gz * gz + saddle * std::abs(n) + 1e-14F);
      distances[i] = std::clamp(columns * fields_.units_a_column, -kMaxDistance, kMaxDistance);
    }
  }
}

}  // namespace talus::terrain
