#include "bends.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <talus/terrain/lattice_hash.h>
#include <talus/voxel/coords.h>

namespace talus::terrain {
namespace {

// Folds are drawn at every eighth column along both axes, and straight lines between: they are far longer.
constexpr std::int64_t kFoldStep = 8;
constexpr int kWanderOctaves = 3;
constexpr std::uint64_t kFoldSeed = 0x464F4C4453000000U;
constexpr std::uint64_t kFaultSeed = 0x4641554C54000000U;
constexpr std::uint64_t kWanderSeed = 0x57414E4445520000U;

Strike strike_of(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  const auto q16 = [](double value) { return static_cast<std::int64_t>(std::floor(value * 65536 + 0.5)); };
  return {q16(std::cos(angle)), q16(std::sin(angle))};
}

std::int64_t columns_of(double units, int resolution) {
  return std::max<std::int64_t>(2, static_cast<std::int64_t>(std::floor(units * resolution + 0.5)));
}

std::int64_t fx_of(std::int64_t units_q16, int resolution) {
  return (units_q16 * resolution * kSubvoxels + 32768) >> 16;
}

}  // namespace

FoldField fold_field(const WorldSpec& spec) {
  FoldField field;
  if (!spec.folds) {
    field.noise = {0, 2, 1};
    return field;
  }
  field.noise = {derived_seed(spec.seed, kFoldSeed), columns_of(spec.folds->wavelength, spec.resolution),
                 spec.folds->octaves};
  field.strike = strike_of(spec.folds->strike);
  field.shrink_q16 = static_cast<std::int64_t>(std::floor(65536 / spec.folds->stretch + 0.5));
  field.amplitude_fx = static_cast<float>(fx_of(spec.folds->amplitude_q16, spec.resolution));
  return field;
}

FaultField fault_field(const WorldSpec& spec, std::size_t set) {
  const FaultSpec& faults = spec.faults[set];
  FaultField field;
  field.seed = derived_seed(spec.seed, kFaultSeed + set);
  field.strike = strike_of(faults.strike);
  field.spacing_q16 = faults.spacing_q16 * spec.resolution;
  field.throw_fx = fx_of(faults.throw_q16, spec.resolution);
  field.wander = {derived_seed(spec.seed, kWanderSeed + set),
                  std::max<std::int64_t>(2, field.spacing_q16 >> 16), kWanderOctaves};
  field.waviness_fx = static_cast<float>(fx_of(faults.waviness_q16, spec.resolution));
  return field;
}

std::int32_t FaultField::lift_fx(std::int64_t index) const {
  const std::uint64_t draw = derived_seed(seed, static_cast<std::uint64_t>(index)) >> 32;
  return static_cast<std::int32_t>(((static_cast<std::int64_t>(draw) * throw_fx) >> 32) - throw_fx / 2);
}

std::int64_t greatest_bend_q16(const WorldSpec& spec) {
  std::int64_t most = spec.folds ? spec.folds->amplitude_q16 : 0;
  for (const FaultSpec& faults : spec.faults) most += (faults.throw_q16 + 1) / 2;
  return most;
}

Bends::Bends(const WorldSpec& spec, InstructionSet set)
    : folded_{spec.folds.has_value()}, folds_{fold_field(spec)}, fold_noise_{folds_.noise}, wander_{set} {
  for (std::size_t i = 0; i < spec.faults.size(); ++i) faults_.push_back(fault_field(spec, i));
}

void Bends::cover(std::span<const std::int64_t> xs, std::span<const std::int64_t> zs, Field& lift_fx) {
  lift_fx.reshape(static_cast<int>(xs.size()), static_cast<int>(zs.size()));
  if (folded_) {
    fold(xs, zs, lift_fx);
  } else {
    std::fill(lift_fx.values.begin(), lift_fx.values.end(), 0);
  }
  for (const FaultField& faults : faults_) fault(faults, xs, zs, lift_fx);
}

void Bends::Lattice::cover(std::span<const std::int64_t> columns) {
  points.clear();
  places.clear();
  const auto index_of = [&](std::int64_t point) {
    if (points.size() > 1 && points[points.size() - 2] == point) return points.size() - 2;
    if (points.empty() || points.back() != point) points.push_back(point);
    return points.size() - 1;
  };
  for (const std::int64_t column : columns) {
    const std::int64_t past = floor_mod(column, kFoldStep);
    const std::size_t before = index_of(column - past);
    const std::size_t after = past == 0 ? before : index_of(column - past + kFoldStep);
    places.push_back({before, after, static_cast<std::int32_t>(past)});
  }
}

// Crests and troughs are rounded off where the noise is strong, so that the amplitude is never passed.
std::int32_t Bends::fold_at(std::int64_t x, std::int64_t z) {
  const std::int64_t across_fx = folds_.strike.across_q16(x, z) >> 8;
  const std::int64_t along_fx = ((folds_.strike.along_q16(x, z) >> 8) * folds_.shrink_q16) >> 16;
  const float s = std::clamp(2.0F * fold_noise_.at(across_fx, along_fx), -1.0F, 1.0F);
  return static_cast<std::int32_t>(folds_.amplitude_fx * (s * (1.5F - 0.5F * (s * s))));
}

void Bends::fold(std::span<const std::int64_t> xs, std::span<const std::int64_t> zs, Field& lift_fx) {
  east_.cover(xs);
  south_.cover(zs);
  coarse_.reshape(static_cast<int>(east_.points.size()), static_cast<int>(south_.points.size()));
  for (int z = 0; z < coarse_.depth; ++z) {
    for (int x = 0; x < coarse_.width; ++x) {
      coarse_.at(x, z) =
          fold_at(east_.points[static_cast<std::size_t>(x)], south_.points[static_cast<std::size_t>(z)]);
    }
  }
  constexpr auto kStep = static_cast<std::int32_t>(kFoldStep);
  between_.resize(east_.points.size());
  for (int z = 0; z < lift_fx.depth; ++z) {
    const Lattice::Place& south = south_.places[static_cast<std::size_t>(z)];
    const auto before = coarse_.row(static_cast<int>(south.before));
    const auto after = coarse_.row(static_cast<int>(south.after));
    for (std::size_t i = 0; i < between_.size(); ++i) {
      between_[i] = before[i] * (kStep - south.past) + after[i] * south.past;
    }
    const auto row = lift_fx.row(z);
    for (std::size_t x = 0; x < row.size(); ++x) {
      const Lattice::Place& east = east_.places[x];
      row[x] = (between_[east.before] * (kStep - east.past) + between_[east.after] * east.past) >> 6;
    }
  }
}

void Bends::fault(const FaultField& faults, std::span<const std::int64_t> xs,
                  std::span<const std::int64_t> zs, Field& lift_fx) {
  const bool straight = faults.waviness_fx == 0;
  if (!straight) wander_.start(faults.wander, xs);
  // The block of the column before, which most columns share: [start, end).
  std::int64_t start = 0;
  std::int64_t end = 0;
  std::int32_t block_lift_fx = 0;
  for (std::size_t z = 0; z < zs.size(); ++z) {
    const float* noise = straight ? nullptr : wander_.row(zs[z]);
    const auto row = lift_fx.row(static_cast<int>(z));
    for (std::size_t x = 0; x < xs.size(); ++x) {
      std::int64_t place = faults.strike.across_q16(xs[x], zs[z]);
      if (!straight)
        place += static_cast<std::int64_t>(static_cast<std::int32_t>(faults.waviness_fx * noise[x])) * 256;
      if (place < start || place >= end) {
        const std::int64_t index = floor_div(place, faults.spacing_q16);
        start = index * faults.spacing_q16;
        end = start + faults.spacing_q16;
        block_lift_fx = faults.lift_fx(index);
      }
      row[x] += block_lift_fx;
    }
  }
}

}  // namespace talus::terrain
