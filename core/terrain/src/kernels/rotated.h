// Noise on rotated lattices (noise/rotated_lattice.h), one row at a time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <talus/vectors/instruction_set.h>

namespace talus::terrain {

struct RotatedLattice;

/// Lanes of 32 bits in the widest vectors.
inline constexpr std::size_t kMaxLanes = 16;

/// Offsets of a vector's columns from its first if columns are evenly spaced: whole cells of the lattice, and
/// the rest in 2^-32 cells. u rises, v falls.
struct LaneSteps {
  std::array<std::uint32_t, kMaxLanes> u_low{};
  std::array<std::uint32_t, kMaxLanes> v_low{};
  std::array<std::uint32_t, kMaxLanes> u_cells{};
  std::array<std::uint32_t, kMaxLanes> v_cells{};
};

/// One octave of a row. Positions of the columns in its lattice, u[i] + row_u and v[i] + row_v, are in 2^-32
/// cells modulo 2^64; u and v are padded.
struct RotatedOctave {
  const RotatedLattice* lattice = nullptr;
  const std::uint64_t* u = nullptr;
  const std::uint64_t* v = nullptr;
  std::uint64_t row_u = 0;
  std::uint64_t row_v = 0;
  float weight = 1;
  /// Null unless columns are evenly spaced; u then rises by step_u per column, and v falls by step_v.
  const LaneSteps* lane_steps = nullptr;
  std::uint64_t step_u = 0;
  std::uint64_t step_v = 0;
};

/// Offsets from the columns at which a row's noise is read, east and south, in 2^-8 columns, at most 2^22 in
/// absolute value. Padded. Null: read at the columns.
struct Displacements {
  const std::int32_t* east = nullptr;
  const std::int32_t* south = nullptr;
};

/// Outputs. Padded.
struct RotatedSums {
  float* value = nullptr;
  /// Rise of the noise per column eastward and southward, where it is read. Both may be null.
  float* east = nullptr;
  float* south = nullptr;
};

struct RotatedKernels {
  /// Sums `count` >= 1 octaves by weight at `width` columns. May write kPadding elements past the end.
  void (*sum)(const RotatedOctave* octaves, std::size_t count, const Displacements& displaced,
              std::size_t width, const RotatedSums& out);
};

[[nodiscard]] const RotatedKernels& rotated_kernels(InstructionSet set);

}  // namespace talus::terrain
