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
  for (Line& line : lines_) {
    line.line.values.resize(kSlowCount + others_.size());
    line.line.east.resize(kSlowCount);
    line.line.south.resize(kSlowCount);
  }
}

void SlowLines::start(std::span<const std::int64_t> samples, bool sloped) {
  width_ = samples.size();
  sloped_ = sloped;
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
  if (sloped) {
    level_.assign(padded(width_), 0);
    for (auto& field : bent_) {
      for (auto& values : field) values.resize(padded(width_));
    }
  }
  for (Warp* const warp : {&east_, &south_}) {
    warp->displacement.resize(padded(width_));
    warp->half.resize(padded(width_));
    warp->by_x.resize(padded(width_));
    warp->by_z.resize(padded(width_));
  }
  for (Line& line : lines_) {
    line.drawn = false;
    for (auto& values : line.line.values) values.resize(padded(width_));
    if (!sloped) continue;
    for (auto* const slopes : {&line.line.east, &line.line.south}) {
      for (auto& values : *slopes) values.assign(padded(width_), 0);  // of climate they stay 0
    }
  }
}

const SlopedLine& SlowLines::at(std::int64_t z) {
  Line& line =
      lines_[static_cast<std::size_t>(floor_mod(z / kSampleStep, static_cast<std::int64_t>(lines_.size())))];
  if (!line.drawn || line.z != z) {
    draw(z, line.line);
    line.z = z;
    line.drawn = true;
  }
  return line.line;
}

void SlowLines::warp(RotatedFbm& wide, RotatedFbm& narrow, std::int64_t z, Warp& warp) const {
  kernels_->displace(wide.sloped_row(z), narrow.sloped_row(z), fields_.warp_reach, width_,
                     warp.displacement.data(), warp.stretch());
  for (std::size_t i = 0; i < width_; ++i) warp.half[i] = warp.displacement[i] >> 1;
}

void SlowLines::draw(std::int64_t z, SlopedLine& line) {
  warp(warp_east_, warp_east_narrow_, z, east_);
  warp(warp_south_, warp_south_narrow_, z, south_);
  if (sloped_) {
    lay_sloped(z, line);
  } else {
    lay(z, line);
  }
  const Displacements warped{east_.displacement.data(), south_.displacement.data()};
  const auto at = [](SlowLine& rows, Slow slow) { return rows[static_cast<std::size_t>(slow)].data(); };
  constexpr std::array<Slow, 3> kRivers{Slow::river, Slow::tributary_a, Slow::tributary_b};
  for (std::size_t i = 0; i < rivers_.size(); ++i) {
    const SlopedOut out{at(line.values, kRivers[i]), sloped_ ? at(line.east, kRivers[i]) : nullptr,
                        sloped_ ? at(line.south, kRivers[i]) : nullptr};
    kernels_->distances(rivers_[i].sloped_row(z, warped), east_.stretch(), south_.stretch(),
                        fields_.saddle[i == 0 ? 0 : 1], fields_.units_a_column, width_, out);
  }
  for (std::size_t i = 0; i < others_.size(); ++i) {
    const SlowFields::Field& other = fields_.others[i];
    kernels_->equalize(other.equalized, others_[i].row(z, other.warped ? warped : Displacements{}), width_,
                       line.values[kSlowCount + i].data());
  }
  // By half the warp, so that hills and ridges bend with the land, and keep their size.
  const Displacements half{east_.half.data(), south_.half.data()};
  constexpr std::array<Slow, kSlowOctaves> kShapes{Slow::shape_0, Slow::shape_1, Slow::shape_2, Slow::shape_3,
                                                   Slow::shape_4};
  for (int k = 0; k < kSlowOctaves; ++k) {
    const Slow slow = kShapes[static_cast<std::size_t>(k)];
    float* const value = at(line.values, slow);
    if (!sloped_) {
      shape_.octave(k, z, {value}, half);
      continue;
    }
    float* const east = at(line.east, slow);
    float* const south = at(line.south, slow);
    shape_.octave(k, z, {value, east, south}, half);
    kernels_->bend({value, east, south}, east_.stretch(), south_.stretch(), 0.5F, width_, east, south);
  }
}

namespace {

SlowLand land_of(SlowLine& rows) {
  const auto out = [&](Slow slow) { return rows[static_cast<std::size_t>(slow)].data(); };
  return {out(Slow::base),    out(Slow::belt),        out(Slow::hills),   out(Slow::mesa),
          out(Slow::terrace), out(Slow::temperature), out(Slow::moisture)};
}

}  // namespace

void SlowLines::lay(std::int64_t z, SlopedLine& line) {
  const Displacements warped{east_.displacement.data(), south_.displacement.data()};
  const auto row = [&](RotatedFbm& noise, const SlowFields::Field& field) {
    return noise.row(z, field.warped ? warped : Displacements{});
  };
  const SlowNoises noises{row(continents_, fields_.continents),   row(ranges_, fields_.ranges),
                          row(hilliness_, fields_.hilliness),     row(mesas_, fields_.mesas),
                          row(temperature_, fields_.temperature), row(moisture_, fields_.moisture)};
  kernels_->lay(noises, fields_, width_, land_of(line.values));
}

void SlowLines::lay_sloped(std::int64_t z, SlopedLine& line) {
  const Displacements warped{east_.displacement.data(), south_.displacement.data()};
  struct One {
    RotatedFbm* noise;
    const SlowFields::Field* field;
    const float* SlowNoises::*row;
    bool shapes = true;  // or the land hardly rises by it
  };
  const std::array<One, 6> all{{{&continents_, &fields_.continents, &SlowNoises::continents},
                                {&ranges_, &fields_.ranges, &SlowNoises::ranges},
                                {&hilliness_, &fields_.hilliness, &SlowNoises::hilliness},
                                {&mesas_, &fields_.mesas, &SlowNoises::mesas},
                                {&temperature_, &fields_.temperature, &SlowNoises::temperature, false},
                                {&moisture_, &fields_.moisture, &SlowNoises::moisture, false}}};
  SlowNoises values;
  SlowNoises east;
  SlowNoises south;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const One& one = all[i];
    const bool bends = one.field->warped;
    if (!one.shapes) {
      values.*one.row = one.noise->row(z, bends ? warped : Displacements{});
      east.*one.row = level_.data();
      south.*one.row = level_.data();
      continue;
    }
    const SlopedRow row = one.noise->sloped_row(z, bends ? warped : Displacements{});
    values.*one.row = row.value;
    east.*one.row = row.east;
    south.*one.row = row.south;
    if (!bends) continue;
    kernels_->bend(row, east_.stretch(), south_.stretch(), 1, width_, bent_[i][0].data(), bent_[i][1].data());
    east.*one.row = bent_[i][0].data();
    south.*one.row = bent_[i][1].data();
  }
  kernels_->lay_sloped(values, east, south, fields_, width_, land_of(line.values), land_of(line.east),
                       land_of(line.south));
}

}  // namespace talus::terrain
