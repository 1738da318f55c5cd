#include "noise/rotated_fbm.h"

#include <cmath>

#include <talus/vectors/tables.h>

namespace talus::terrain {
namespace {

constexpr std::int64_t kMaxEvenStep = 1 << 16;  // so that a vector's columns stay within 2^64 of its first

RotatedLattice lattice_of(const RotatedNoise& noise, int k) {
  const std::uint64_t seed = derived_seed(noise.seed, static_cast<std::uint64_t>(k));
  return rotated_lattice(seed, noise.period, k, noise.turn);
}

double share_of(const RotatedNoise& noise, int k) {
  double share = 1;
  for (int i = 0; i < k; ++i) share *= noise.gain;
  return share;
}

double sum_of_powers(const RotatedNoise& noise, int power) {
  double sum = 0;
  for (int k = 0; k < noise.octaves; ++k) sum += share_of(noise, power * k);
  return sum;
}

std::uint64_t displaced_by(std::uint64_t sum) {
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(sum) >> 8);
}

std::uint64_t even_step(std::span<const std::int64_t> xs) {
  if (xs.size() < 2 || xs[1] <= xs[0] || xs[1] - xs[0] > kMaxEvenStep) return 0;
  for (std::size_t i = 2; i < xs.size(); ++i) {
    if (xs[i] - xs[i - 1] != xs[1] - xs[0]) return 0;
  }
  return static_cast<std::uint64_t>(xs[1] - xs[0]);
}

LaneSteps lane_steps_of(const RotatedLattice& lattice, std::uint64_t step) {
  LaneSteps steps;
  for (std::size_t lane = 0; lane < kMaxLanes; ++lane) {
    const std::uint64_t u = lattice.du * step * lane;
    const std::uint64_t v = lattice.dv * step * lane;
    steps.u_low[lane] = static_cast<std::uint32_t>(u);
    steps.v_low[lane] = static_cast<std::uint32_t>(v);
    steps.u_cells[lane] = static_cast<std::uint32_t>(u >> 32);
    steps.v_cells[lane] = static_cast<std::uint32_t>(v >> 32);
  }
  return steps;
}

}  // namespace

double RotatedNoise::deviation() const {
  return kRotatedDeviation * std::sqrt(sum_of_powers(*this, 2));
}

double RotatedNoise::dominance() const {
  const double squares = sum_of_powers(*this, 2);
  return sum_of_powers(*this, 4) / (squares * squares);
}

void RotatedFbm::start(const RotatedNoise& noise, std::span<const std::int64_t> xs) {
  width_ = xs.size();
  step_ = even_step(xs);
  count_ = static_cast<std::size_t>(noise.octaves);
  if (octaves_.size() < count_) octaves_.resize(count_);
  for (std::size_t k = 0; k < count_; ++k) {
    Octave& octave = octaves_[k];
    octave.lattice = lattice_of(noise, static_cast<int>(k));
    octave.weight = static_cast<float>(share_of(noise, static_cast<int>(k)));
    octave.lane_steps = lane_steps_of(octave.lattice, step_);
    octave.u.resize(padded(width_));
    octave.v.resize(padded(width_));
    for (std::size_t i = 0; i < width_; ++i) {
      octave.u[i] = octave.lattice.u(xs[i], 0);
      octave.v[i] = octave.lattice.v(xs[i], 0);
    }
  }
  placed_.reserve(count_);
  noise_.resize(padded(width_));
}

RotatedOctave RotatedFbm::placed(const Octave& octave, std::int64_t z) const {
  const auto south = static_cast<std::uint64_t>(z);
  return {&octave.lattice,
          octave.u.data(),
          octave.v.data(),
          octave.lattice.dv * south,
          octave.lattice.du * south,
          octave.weight,
          step_ == 0 ? nullptr : &octave.lane_steps,
          octave.lattice.du * step_,
          octave.lattice.dv * step_};
}

void RotatedFbm::place(std::int64_t z) {
  placed_.clear();
  for (std::size_t k = 0; k < count_; ++k) placed_.push_back(placed(octaves_[k], z));
}

SlopedRow RotatedFbm::sloped_row(std::int64_t z, const Displacements& displaced) {
  return sloped_part(z, displaced, 0, width_);
}

SlopedRow RotatedFbm::sloped_part(std::int64_t z, const Displacements& displaced, std::size_t first,
                                  std::size_t last) {
  east_.resize(padded(width_));
  south_.resize(padded(width_));
  place(z);
  for (RotatedOctave& octave : placed_) {
    octave.u += first;
    octave.v += first;
  }
  Displacements here = displaced;
  if (here.east != nullptr) here = {displaced.east + first, displaced.south + first};
  kernels_->sum(placed_.data(), count_, here, last - first,
                {noise_.data() + first, east_.data() + first, south_.data() + first});
  return {noise_.data(), east_.data(), south_.data()};
}

const float* RotatedFbm::row(std::int64_t z, const Displacements& displaced) {
  place(z);
  kernels_->sum(placed_.data(), count_, displaced, width_, {noise_.data()});
  return noise_.data();
}

void RotatedFbm::octave(int k, std::int64_t z, const RotatedSums& out, const Displacements& displaced) {
  RotatedOctave one = placed(octaves_[static_cast<std::size_t>(k)], z);
  one.weight = 1;
  kernels_->sum(&one, 1, displaced, width_, out);
}

RotatedPoints::RotatedPoints(const RotatedNoise& noise) {
  for (int k = 0; k < noise.octaves; ++k) {
    octaves_.push_back({lattice_of(noise, k), static_cast<float>(share_of(noise, k))});
  }
}

float RotatedPoints::at(std::int64_t x, std::int64_t z) const {
  float sum = 0;
  for (const Octave& octave : octaves_) {
    const RotatedLattice& lattice = octave.lattice;
    sum += octave.weight * rotated_sample(lattice, lattice.u(x, z), lattice.v(x, z)).value;
  }
  return sum;
}

SlopedNoise sloped_rotated_fbm(const RotatedNoise& noise, std::int64_t x, std::int64_t z, std::int32_t east,
                               std::int32_t south) {
  const auto e = static_cast<std::uint64_t>(std::int64_t{east});
  const auto s = static_cast<std::uint64_t>(std::int64_t{south});
  SlopedNoise sum;
  for (int k = 0; k < noise.octaves; ++k) {
    const RotatedLattice lattice = lattice_of(noise, k);
    const std::uint64_t u = lattice.u(x, z) + displaced_by(lattice.du * e + lattice.dv * s);
    const std::uint64_t v = lattice.v(x, z) + displaced_by(lattice.du * s - lattice.dv * e);
    const RotatedSample sample = rotated_sample(lattice, u, v);
    const auto weight = static_cast<float>(share_of(noise, k));
    const float u_share = weight * lattice.u_a_column();
    const float v_share = weight * lattice.v_a_column();
    sum.value += weight * sample.value;
    sum.east += sample.along_u * u_share - sample.along_v * v_share;
    sum.south += sample.along_u * v_share + sample.along_v * u_share;
  }
  return sum;
}

}  // namespace talus::terrain
