// Perlin noise, one row at a time.
//
// Between two neighbouring lattice lines along x, at v of the way from the first (line 0) to the second
// (line 1), the noise of one octave is
//   n(v) = (1 - f) (value_0 + slope_0 v) + f (value_1 + slope_1 (v - 1)),   f = fade(v),
// where value and slope depend only on the column and the line. They are computed once per line, so each row
// between costs four products per column and octave, whatever the wavelength.
#pragma once

#include <cstddef>
#include <cstdint>

#include <talus/vectors/aligned.h>
#include <talus/vectors/instruction_set.h>

namespace talus::terrain {

/// Positions of a row's columns in the lattice of one octave. Adjacent columns in the same cell form a run.
/// All arrays are padded.
struct LatticeColumns {
  std::size_t width = 0;
  std::size_t runs = 0;
  AlignedVector<float> t;                  // by column: 0 to 1 within its cell
  AlignedVector<float> faded;              // by column: fade(t)
  AlignedVector<std::int32_t> run;         // by column: index of its run
  AlignedVector<std::uint32_t> west_hash;  // by run: the hash of its cell's west side, see axis_hash()
  AlignedVector<std::uint32_t> east_hash;
};

/// The contribution of the corners on one lattice line along x to the noise of each column. Padded.
struct LatticeLine {
  AlignedVector<float> value;  // on the line itself
  AlignedVector<float> slope;  // per cell of distance from the line, toward greater z
};

/// One octave of one row: the lines on both sides of it, and their weights.
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
  /// Computes LatticeColumns::t for columns of one cell: the first is `inside` base columns from its west
  /// side, and they are `apart` apart. May write kPadding elements past the end; so may fade_columns.
  void (*place_columns)(std::int32_t inside, std::int32_t apart, std::size_t count, float reciprocal,
                        float* t);
  /// Computes LatticeColumns::faded.
  void (*fade_columns)(const float* t, std::size_t width, float* faded);
  /// `gradients` is scratch: 4 * padded(runs) floats.
  void (*draw_line)(const LatticeColumns& columns, std::uint32_t z_hash, float weight, float* gradients,
                    LatticeLine& line);
  /// Sums the octaves of columns [first, last) into out[first, last). May write kPadding past the end.
  void (*blend)(const OctaveRow* octaves, std::size_t count, std::size_t first, std::size_t last, float* out);
  /// heights_fx = clamp(0.5 + gain * noise, 0, 1)^exponent * highest_fx, rounded to even.
  void (*shape)(const float* noise, std::size_t width, float gain, int exponent, float highest_fx,
                std::int32_t* heights_fx);
};

[[nodiscard]] const NoiseKernels& noise_kernels(InstructionSet set);

}  // namespace talus::terrain
