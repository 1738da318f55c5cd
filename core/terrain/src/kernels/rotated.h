// Noise on rotated lattices (noise/rotated_lattice.h), a row at a time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <talus/vectors/instruction_set.h>

namespace talus::terrain {

struct RotatedLattice;

/// Of 32 bits, in the widest vectors.
inline constexpr std::size_t kMaxLanes = 16;

/// How far the columns of a vector are from its first where all are as far apart: cells of the lattice, and
/// the rest in 2^-32 cells. u rises, v falls.
struct LaneSteps {
  std::array<std::uint32_t, kMaxLanes> u_low{};
  std::array<std::uint32_t, kMaxLanes> v_low{};
  std::array<std::uint32_t, kMaxLanes> u_cells{};
  std::array<std::uint32_t, kMaxLanes> v_cells{};
};

/// One octave of a row. The columns' places in its lattice, u[i] + row_u and v[i] + row_v, are in 2^-32 cells
/// modulo 2^64; u and v are padded.
struct RotatedOctave {
  const RotatedLattice* lattice = nullptr;
  const std::uint64_t* u = nullptr;
  const std::uint64_t* v = nullptr;
  std::uint64_t row_u = 0;
  std::uint64_t row_v = 0;
  float weight = 1;
  /// Of evenly spaced columns, whose u rises and v falls by so much; else null.
  const LaneSteps* lane_steps = nullptr;
  std::uint64_t step_u = 0;
  std::uint64_t step_v = 0;
};

/// Where a row's noise is read instead of at its columns: so far east and south, in 2^-8 columns, at most
/// 2^22 either way. Padded. Null: at its columns.
struct Displacements {
  const std::int32_t* east = nullptr;
  const std::int32_t* south = nullptr;
};

/// Where sums go. Padded.
struct RotatedSums {
  float* value = nullptr;
  /// How the noise rises a column eastward and southward, at the place where it is read. Both may be null.
  float* east = nullptr;
  float* south = nullptr;
};

struct RotatedKernels {
  /// The weighted sum of `count` octaves, at least one, at `width` columns. Writes up to kPadding further.
  void (*sum)(const RotatedOctave* octaves, std::size_t count, const Displacements& displaced,
              std::size_t width, const RotatedSums& out);
};

[[nodiscard]] const RotatedKernels& rotated_kernels(InstructionSet set);

}  // namespace talus::terrain
