#include "surface/regions/slow_lines.h"

#include <algorithm>

#include <talus/vectors/tables.h>

#include "noise/lattice_place.h"

namespace talus::terrain {

SlowLines::SlowLines(const SlowFields& fields, const RotatedNoise& shape, const RegionShape& land,
                     InstructionSet set)
    : fields_{fields},
      shape_noise_{shape},
      land_{land},
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
      for (auto& values : *slopes) values.assign(padded(width_), 0);  // stays 0 for the climate
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

namespace {

constexpr std::array<Slow, 3> kRiverRows{Slow::river, Slow::tributary_a, Slow::tributary_b};

float* slow_row(SlowLine& rows, Slow slow) {
  return rows[static_cast<std::size_t>(slow)].data();
}

/// Calls part(first, last) for ranges of whole vectors that contain all columns with `wanted`.
template <class Wanted, class Part>
void in_parts(std::size_t width, const Wanted& wanted, const Part& part) {
  const auto any = [&](std::size_t first) {
    const std::size_t last = std::min(first + kMaxLanes, width);
    for (std::size_t i = first; i < last; ++i) {
      if (wanted(i)) return true;
    }
    return false;
  };
  for (std::size_t first = 0; first < width; first += kMaxLanes) {
    if (!any(first)) continue;
    std::size_t last = first + kMaxLanes;
    while (last < width && any(last)) last += kMaxLanes;
    part(first, std::min(last, width));
    first = last;
  }
}

SlopedRow from_column(const SlopedRow& row, std::size_t first) {
  return {row.value + first, row.east + first, row.south + first};
}

Stretch from_column(const Stretch& stretch, std::size_t first) {
  return {stretch.by_x + first, stretch.by_z + first};
}

}  // namespace

void SlowLines::draw(std::int64_t z, SlopedLine& line) {
  warp(warp_east_, warp_east_narrow_, z, east_);
  warp(warp_south_, warp_south_narrow_, z, south_);
  const Displacements warped{east_.displacement.data(), south_.displacement.data()};
  if (sloped_) {
    lay_sloped(z, line);
    draw_terraces_in_parts(z, line);
    draw_rivers_in_parts(z, line);
  } else {
    lay(z, line);
    draw_rivers(z, line);
  }
  for (std::size_t i = 0; i < others_.size(); ++i) {
    const SlowFields::Field& other = fields_.others[i];
    kernels_->equalize(other.equalized, others_[i].row(z, other.warped ? warped : Displacements{}), width_,
                       line.values[kSlowCount + i].data());
  }
  draw_shape(z, line);
}

void SlowLines::draw_rivers(std::int64_t z, SlopedLine& line) {
  const Displacements warped{east_.displacement.data(), south_.displacement.data()};
  for (std::size_t i = 0; i < rivers_.size(); ++i) {
    kernels_->distances(rivers_[i].sloped_row(z, warped), east_.stretch(), south_.stretch(),
                        fields_.saddle[i == 0 ? 0 : 1], fields_.units_a_column, width_,
                        {slow_row(line.values, kRiverRows[i]), nullptr, nullptr});
  }
}

// Nothing is interpolated between these samples, so values without effect on their own sample are omitted:
// tributaries on the other side of a river, and rivers where the highest possible land, with every hill and
// ridge, is deep under the sea. Rivers cut only land above their flood plain, which is above 0; the sea's
// floor has no beds; and no terraces are there whose field a valley could lower.
void SlowLines::draw_rivers_in_parts(std::int64_t z, SlopedLine& line) {
  constexpr float kFar = 1000;
  constexpr float kDeep = -11;  // beds end at -9
  const float* const base = slow_row(line.values, Slow::base);
  const float* const belt = slow_row(line.values, Slow::belt);
  const float* const hills = slow_row(line.values, Slow::hills);
  const float* const mesa = slow_row(line.values, Slow::mesa);
  const float* const river = slow_row(line.values, Slow::river);
  const float ranges = 1.2F * (std::max(land_.range_base, 0.0F) + std::max(land_.range_relief, 0.0F));
  const auto cut = [&](std::size_t i) {
    const float highest = base[i] + std::max(belt[i], 0.0F) * ranges + std::max(hills[i], 0.0F);
    return mesa[i] > 0 || !(highest < kDeep);
  };
  const Displacements warped{east_.displacement.data(), south_.displacement.data()};
  for (std::size_t k = 0; k < rivers_.size(); ++k) {
    const SlopedOutput out{slow_row(line.values, kRiverRows[k]), slow_row(line.east, kRiverRows[k]),
                           slow_row(line.south, kRiverRows[k])};
    std::fill_n(out.value, width_, kFar);
    std::fill_n(out.east, width_, 0.0F);
    std::fill_n(out.south, width_, 0.0F);
    const auto wanted = [&](std::size_t i) { return cut(i) && (k == 0 || (river[i] > 0) == (k == 1)); };
    in_parts(width_, wanted, [&](std::size_t first, std::size_t last) {
      kernels_->distances(from_column(rivers_[k].sloped_part(z, warped, first, last), first),
                          from_column(east_.stretch(), first), from_column(south_.stretch(), first),
                          fields_.saddle[k == 0 ? 0 : 1], fields_.units_a_column, last - first,
                          {out.value + first, out.east + first, out.south + first});
    });
  }
}

// Omits the field of terraces too where there is no mesa country.
void SlowLines::draw_terraces_in_parts(std::int64_t z, SlopedLine& line) {
  const Displacements warped{east_.displacement.data(), south_.displacement.data()};
  const float* const mesa = slow_row(line.values, Slow::mesa);
  const SlopedOutput out{slow_row(line.values, Slow::terrace), slow_row(line.east, Slow::terrace),
                         slow_row(line.south, Slow::terrace)};
  std::fill_n(out.value, width_, 0.0F);
  std::fill_n(out.east, width_, 0.0F);
  std::fill_n(out.south, width_, 0.0F);
  const bool bends = fields_.mesas.warped;
  in_parts(
      width_, [&](std::size_t i) { return mesa[i] > 0; },
      [&](std::size_t first, std::size_t last) {
        SlopedRow noise =
            from_column(mesas_.sloped_part(z, bends ? warped : Displacements{}, first, last), first);
        if (bends) {
          float* const east = bent_[0][0].data() + first;
          float* const south = bent_[0][1].data() + first;
          kernels_->bend(noise, from_column(east_.stretch(), first), from_column(south_.stretch(), first), 1,
                         last - first, east, south);
          noise = {noise.value, east, south};
        }
        kernels_->equalize_sloped(fields_.mesas.equalized, noise, last - first,
                                  {out.value + first, out.east + first, out.south + first});
      });
}

// Displaced by half the warp, so that hills and ridges bend with the land but keep their size.
void SlowLines::draw_shape(std::int64_t z, SlopedLine& line) {
  const Displacements half{east_.half.data(), south_.half.data()};
  constexpr std::array<Slow, kSlowOctaves> kShapes{Slow::shape_0, Slow::shape_1, Slow::shape_2, Slow::shape_3,
                                                   Slow::shape_4};
  for (int k = 0; k < kSlowOctaves; ++k) {
    const Slow slow = kShapes[static_cast<std::size_t>(k)];
    float* const value = slow_row(line.values, slow);
    if (!sloped_) {
      shape_.octave(k, z, {value}, half);
      continue;
    }
    float* const east = slow_row(line.east, slow);
    float* const south = slow_row(line.south, slow);
    shape_.octave(k, z, {value, east, south}, half);
    kernels_->bend({value, east, south}, east_.stretch(), south_.stretch(), 0.5F, width_, east, south);
  }
}

namespace {

SlowLand land_of(SlowLine& rows) {
  const auto out = [&](Slow slow) { return rows[static_cast<std::size_t>(slow)].data(); };
  return {out(Slow::base), out(Slow::belt),        out(Slow::hills),
          out(Slow::mesa), out(Slow::temperature), out(Slow::moisture)};
}

}  // namespace

void SlowLines::lay(std::int64_t z, SlopedLine& line) {
  const Displacements warped{east_.displacement.data(), south_.displacement.data()};
  const auto row = [&](RotatedFbm& noise, const SlowFields::Field& field) {
    return noise.row(z, field.warped ? warped : Displacements{});
  };
  const SlowNoises noises{row(continents_, fields_.continents), row(ranges_, fields_.ranges),
                          row(hilliness_, fields_.hilliness), row(temperature_, fields_.temperature),
                          row(moisture_, fields_.moisture)};
  kernels_->lay(noises, fields_, width_, land_of(line.values));
  kernels_->equalize(fields_.mesas.equalized, row(mesas_, fields_.mesas), width_,
                     slow_row(line.values, Slow::terrace));
}

void SlowLines::lay_sloped(std::int64_t z, SlopedLine& line) {
  const Displacements warped{east_.displacement.data(), south_.displacement.data()};
  struct One {
    RotatedFbm* noise;
    const SlowFields::Field* field;
    const float* SlowNoises::*row;
    bool shapes = true;  // false if it hardly shapes the land
  };
  const std::array<One, 5> all{{{&continents_, &fields_.continents, &SlowNoises::continents},
                                {&ranges_, &fields_.ranges, &SlowNoises::ranges},
                                {&hilliness_, &fields_.hilliness, &SlowNoises::hilliness},
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
