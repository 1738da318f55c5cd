// Perlin noise, a row at a time.
//
// Between two neighbouring lattice lines along x, at v of the way from the first (line 0) to the second
// (line 1), the noise of one octave is
//   n(v) = (1 - f) (value_0 + slope_0 v) + f (value_1 + slope_1 (v - 1)),   f = fade(v),
// where value and slope depend on the column and the line alone. So they are drawn once a line, and each
// row between costs four products a column and octave, whatever the wavelength.
#pragma once

#include <cstddef>
#include <cstdint>

#include <talus/vectors/aligned.h>
#include <talus/vectors/instruction_set.h>

namespace talus::terrain {

/// Where the columns of a row lie in the lattice of one octave. Neighbouring columns in the same cell are a
/// run. All arrays are padded.
struct LatticeColumns {
  std::size_t width = 0;
  std::size_t runs = 0;
  AlignedVector<float> t;                  // a column: 0 to 1 within its cell
  AlignedVector<float> faded;              // a column: fade(t)
  AlignedVector<std::int32_t> run;         // a column: which run it belongs to
  AlignedVector<std::uint32_t> west_hash;  // a run: what the cell's west side adds to the hash of a corner
  AlignedVector<std::uint32_t> east_hash;
};

/// What the corners on one lattice line along x add to the noise of each column. Padded.
struct LatticeLine {
  AlignedVector<float> value;  // on the line itself
  AlignedVector<float> slope;  // and with each cell of distance from it, toward greater z
};

/// One octave of one row: the lines on both sides of it, and how much of each.
struct OctaveRow {
  const float* value_0 = nullptr;
  const float* slope_0 = nullptr;
  const float* value_1 = nullptr;
  const float* slope_1 = nullptr;
  float value_0_share = 0;  // 1 - f
  float slope_0_share = 0;  // (1 - f) v
  float value_1_share = 0;  // f
  float slope_1_share = 0;  // f (v - 1)
};

struct NoiseKernels {
  /// LatticeColumns' t: of columns of a cell, the first `inside` base columns from its west side and each
  /// `apart` from the one before. May write up to kPadding further, and so may the next.
  void (*place_columns)(std::int32_t inside, std::int32_t apart, std::size_t count, float reciprocal,
                        float* t);
  /// And its faded.
  void (*fade_columns)(const float* t, std::size_t width, float* faded);
  /// `gradients` is scratch: 4 * padded(runs) floats.
  void (*draw_line)(const LatticeColumns& columns, std::uint32_t z_hash, float weight, float* gradients,
                    LatticeLine& line);
  /// Sums the octaves of columns [first, last) into out[first, last), and may write up to kPadding further.
  void (*blend)(const OctaveRow* octaves, std::size_t count, std::size_t first, std::size_t last, float* out);
  /// heights_fx = clamp(0.5 + gain * noise, 0, 1)^exponent * highest_fx, rounded to even.
  void (*shape)(const float* noise, std::size_t width, float gain, int exponent, float highest_fx,
                std::int32_t* heights_fx);
};

[[nodiscard]] const NoiseKernels& noise_kernels(InstructionSet set);

}  // namespace talus::terrain
