#include "noise/fbm_rows.h"

#include <algorithm>
#include <utility>

#include <talus/vectors/tables.h>

#include "noise/lattice_place.h"

namespace talus::terrain {
namespace {

std::int64_t position_of(std::int64_t coordinate, int k, std::int64_t offset) {
  return coordinate * (std::int64_t{1} << k) + offset;
}

// Minimum columns of a run that is filled at once.
constexpr std::int64_t kMinRun = 4;
// Minimum columns of a run that is filled by vectors.
constexpr std::size_t kLongRun = 32;

/// The distance between columns if it is the same for all, else 0.
std::int64_t even_distance(std::span<const std::int64_t> xs) {
  if (xs.size() < 2) return 0;
  const std::int64_t step = xs[1] - xs[0];
  for (std::size_t i = 2; i < xs.size(); ++i) {
    if (xs[i] - xs[i - 1] != step) return 0;
  }
  return step;
}

// Never shrinks, so that a kernel's reads past the end stay valid.
template <class T>
void grow(AlignedVector<T>& buffer, std::size_t size) {
  if (buffer.size() < padded(size)) buffer.resize(padded(size));
}

}  // namespace

void FbmRows::start(const Fbm& fbm, std::span<const std::int64_t> xs, Weights weights) {
  fbm_ = fbm;
  set_columns(xs);
  count_ = 0;
  while (static_cast<int>(count_) < fbm.octaves && fbm.has_octave(static_cast<int>(count_))) ++count_;
  if (octaves_.size() < count_) octaves_.resize(count_);
  shares_.resize(count_);
  grow(noise_, xs.size());
  grow(gradients_, 4 * padded(xs.size()));
  for (std::size_t i = 0; i < count_; ++i) {
    const int k = static_cast<int>(i);
    Octave& octave = octaves_[i];
    octave.seed = derived_seed(fbm.seed, i);
    octave.weight = weights == Weights::halving ? octave_weight(fbm, k) : 1.0F;
    octave.z_offset = offset_of(octave.seed, Axis::z, fbm.period);
    octave.z = 0;
    octave.cell = floor_div(octave.z_offset, fbm.period);
    octave.inside = floor_mod(octave.z_offset, fbm.period);
    octave.drawn = false;
    locate_columns(octave, k, xs);
  }
}

// Consecutive noises often have the same columns.
void FbmRows::set_columns(std::span<const std::int64_t> xs) {
  width_ = xs.size();
  if (std::ranges::equal(xs_, xs)) return;
  xs_.assign(xs.begin(), xs.end());
  step_ = even_distance(xs);
}

void FbmRows::locate_columns(Octave& octave, int k, std::span<const std::int64_t> xs) const {
  LatticeColumns& columns = octave.columns;
  columns.width = xs.size();
  columns.runs = 0;
  grow(columns.t, xs.size());
  grow(columns.faded, xs.size());
  grow(columns.run, xs.size());
  grow(columns.west_hash, xs.size());
  grow(columns.east_hash, xs.size());
  for (LatticeLine& line : octave.lines) {
    grow(line.value, xs.size());
    grow(line.slope, xs.size());
  }
  const std::int64_t offset = offset_of(octave.seed, Axis::x, fbm_.period);
  const float reciprocal = 1.0F / static_cast<float>(fbm_.period);
  std::int64_t cell = 0;
  std::int64_t inside = 0;
  std::int64_t run_cell = 0;
  std::int64_t previous = 0;
  for (std::size_t i = 0; i < xs.size();) {
    const std::int64_t position = position_of(xs[i], k, offset);
    step_to(position - previous, fbm_.period, cell, inside);
    previous = position;
    if (i == 0 || cell != run_cell) {
      const bool adjoins = i > 0 && cell == run_cell + 1;
      columns.west_hash[columns.runs] =
          adjoins ? columns.east_hash[columns.runs - 1] : axis_hash(octave.seed, Axis::x, cell);
      columns.east_hash[columns.runs] = axis_hash(octave.seed, Axis::x, cell + 1);
      run_cell = cell;
      ++columns.runs;
    }
    // Columns that surely lie in the same cell: all of them if columns are evenly spaced and close.
    const std::int64_t step = step_ * (std::int64_t{1} << k);
    const bool close = step > 0 && kMinRun * step <= fbm_.period;
    const std::size_t end =
        close ? std::min(xs.size(), i + static_cast<std::size_t>((fbm_.period - 1 - inside) / step) + 1)
              : i + 1;
    const auto first = static_cast<std::int32_t>(inside);
    const auto apart = static_cast<std::int32_t>(close ? step : 0);
    float* const t = columns.t.data() + i;
    if (end - i >= kLongRun) {
      // Values written past the run are overwritten by the next.
      kernels_->place_columns(first, apart, end - i, reciprocal, t);
    } else {
      const auto count = static_cast<std::int32_t>(end - i);
      for (std::int32_t j = 0; j < count; ++j) t[j] = static_cast<float>(first + j * apart) * reciprocal;
    }
    std::fill(columns.run.begin() + static_cast<std::ptrdiff_t>(i),
              columns.run.begin() + static_cast<std::ptrdiff_t>(end),
              static_cast<std::int32_t>(columns.runs - 1));
    i = end;
  }
  kernels_->fade_columns(columns.t.data(), xs.size(), columns.faded.data());
  // Lanes past the end belong to the last run, so that they stay within a vector of it.
  std::fill(columns.run.begin() + static_cast<std::ptrdiff_t>(xs.size()), columns.run.end(),
            static_cast<std::int32_t>(columns.runs) - 1);
}

void FbmRows::draw(const Octave& octave, std::int64_t lattice_z, LatticeLine& line) {
  const std::uint32_t hash = axis_hash(octave.seed, Axis::z, lattice_z);
  kernels_->draw_line(octave.columns, (hash << 16) | (hash >> 16), octave.weight, gradients_.data(), line);
}

void FbmRows::move_to(Octave& octave, int k, std::int64_t z) {
  const std::int64_t before = octave.cell;
  step_to((z - octave.z) * (std::int64_t{1} << k), fbm_.period, octave.cell, octave.inside);
  octave.z = z;
  if (octave.drawn && octave.cell == before) return;
  if (octave.drawn && octave.cell == before + 1) {
    std::swap(octave.lines[0], octave.lines[1]);
  } else {
    draw(octave, octave.cell, octave.lines[0]);
  }
  draw(octave, octave.cell + 1, octave.lines[1]);
  octave.drawn = true;
}

std::span<const OctaveRow> FbmRows::octaves(std::int64_t z) {
  const float reciprocal = 1.0F / static_cast<float>(fbm_.period);
  for (std::size_t i = 0; i < count_; ++i) {
    Octave& octave = octaves_[i];
    move_to(octave, static_cast<int>(i), z);
    const float v = static_cast<float>(octave.inside) * reciprocal;
    const float f = fade(v);
    shares_[i] = {octave.lines[0].value.data(),
                  octave.lines[0].slope.data(),
                  octave.lines[1].value.data(),
                  octave.lines[1].slope.data(),
                  1.0F - f,
                  (1.0F - f) * v,
                  f,
                  f * (v - 1.0F)};
  }
  return shares_;
}

const float* FbmRows::row(std::int64_t z, std::size_t first, std::size_t last) {
  kernels_->blend(octaves(z).data(), count_, first, last, noise_.data());
  return noise_.data();
}

void FbmRows::row_into(std::int64_t z, float* noise) {
  kernels_->blend(octaves(z).data(), count_, 0, width_, noise);
}

}  // namespace talus::terrain
