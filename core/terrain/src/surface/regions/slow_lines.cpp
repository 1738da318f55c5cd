#include "surface/regions/slow_lines.h"

#include <algorithm>

#include <talus/vectors/tables.h>

#include "noise/lattice_place.h"

namespace talus::terrain {

SlowLines::SlowLines(const SlowFields& fields, const RotatedNoise& shape, InstructionSet set)
    : fields_{fields},
      shape_noise_{shape},
      kernels_{&region_kernels(set)},
      warp_east_{set},
      warp_east_narrow_{set},
      warp_south_{set},
      warp_south_narrow_{set},
      continents_{set},
      ranges_{set},
      hilliness_{set},
      mesas_{set},
      temperature_{set},
      moisture_{set},
      shape_{set},
      rivers_{RotatedFbm{set}, RotatedFbm{set}, RotatedFbm{set}},
      others_(fields.others.size(), RotatedFbm{set}) {
  for (Line& line : lines_) line.values.resize(kSlowCount + others_.size());
}

void SlowLines::start(std::span<const std::int64_t> samples) {
  width_ = samples.size();
  warp_east_.start(fields_.warp_east[0], samples);
  warp_east_narrow_.start(fields_.warp_east[1], samples);
  warp_south_.start(fields_.warp_south[0], samples);
  warp_south_narrow_.start(fields_.warp_south[1], samples);
  continents_.start(fields_.continents.noise, samples);
  ranges_.start(fields_.ranges.noise, samples);
  hilliness_.start(fields_.hilliness.noise, samples);
  mesas_.start(fields_.mesas.noise, samples);
  temperature_.start(fields_.temperature.noise, samples);
  moisture_.start(fields_.moisture.noise, samples);
  RotatedNoise slow_shape = shape_noise_;
  slow_shape.octaves = kSlowOctaves;
  shape_.start(slow_shape, samples);
  for (std::size_t i = 0; i < rivers_.size(); ++i) rivers_[i].start(fields_.rivers[i], samples);
  for (std::size_t i = 0; i < others_.size(); ++i) others_[i].start(fields_.others[i].noise, samples);
  for (Warp* const warp : {&east_, &south_}) {
    warp->displacement.resize(padded(width_));
    warp->half.resize(padded(width_));
    warp->by_x.resize(padded(width_));
    warp->by_z.resize(padded(width_));
  }
  for (Line& line : lines_) {
    line.drawn = false;
    for (auto& values : line.values) values.resize(padded(width_));
  }
}

const SlowLine& SlowLines::at(std::int64_t z) {
  Line& line = lines_[static_cast<std::size_t>(floor_mod(z / kSampleStep, 2))];
  if (!line.drawn || line.z != z) {
    draw(z, line.values);
    line.z = z;
    line.drawn = true;
  }
  return line.values;
}

void SlowLines::warp(RotatedFbm& wide, RotatedFbm& narrow, std::int64_t z, Warp& warp) const {
  kernels_->displace(wide.sloped_row(z), narrow.sloped_row(z), fields_.warp_reach, width_,
                     warp.displacement.data(), warp.stretch());
  for (std::size_t i = 0; i < width_; ++i) warp.half[i] = warp.displacement[i] >> 1;
}

void SlowLines::draw(std::int64_t z, SlowLine& line) {
  warp(warp_east_, warp_east_narrow_, z, east_);
  warp(warp_south_, warp_south_narrow_, z, south_);
  const Displacements warped{east_.displacement.data(), south_.displacement.data()};
  const auto row = [&](RotatedFbm& noise, const SlowFields::Field& field) {
    return noise.row(z, field.warped ? warped : Displacements{});
  };
  const SlowNoises noises{row(continents_, fields_.continents),   row(ranges_, fields_.ranges),
                          row(hilliness_, fields_.hilliness),     row(mesas_, fields_.mesas),
                          row(temperature_, fields_.temperature), row(moisture_, fields_.moisture)};
  const auto out = [&](Slow slow) { return line[static_cast<std::size_t>(slow)].data(); };
  kernels_->lay(noises, fields_, width_,
                {out(Slow::base), out(Slow::belt), out(Slow::hills), out(Slow::mesa), out(Slow::terrace),
                 out(Slow::temperature), out(Slow::moisture)});
  constexpr std::array<Slow, 3> kRivers{Slow::river, Slow::tributary_a, Slow::tributary_b};
  for (std::size_t i = 0; i < rivers_.size(); ++i) {
    kernels_->distances(rivers_[i].sloped_row(z, warped), east_.stretch(), south_.stretch(),
                        fields_.saddle[i == 0 ? 0 : 1], fields_.units_a_column, width_, out(kRivers[i]));
  }
  for (std::size_t i = 0; i < others_.size(); ++i) {
    const SlowFields::Field& other = fields_.others[i];
    kernels_->equalize(other.equalized, row(others_[i], other), width_, line[kSlowCount + i].data());
  }
  // By half the warp, so that hills and ridges bend with the land, and keep their size.
  const Displacements half{east_.half.data(), south_.half.data()};
  constexpr std::array<Slow, kSlowOctaves> kShapes{Slow::shape_0, Slow::shape_1, Slow::shape_2};
  for (int k = 0; k < kSlowOctaves; ++k) {
    std::copy_n(shape_.octave(k, z, half), width_, out(kShapes[static_cast<std::size_t>(k)]));
  }
}

}  // namespace talus::terrain
