// fBm at displaced positions, a row at a time: what a warped surface stands on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <talus/vectors/instruction_set.h>

namespace talus::terrain {

/// One octave of a row. Positions are in subvoxels of the octave; the undisplaced one of column i lies
/// x_inside[i] into the cell whose key (lattice_hash.h) is x_key[i]. Padded.
struct DisplacedOctave {
  float weight = 0;
  double frequency = 0;  // 2^k: what a displacement grows by
  std::vector<double> x_inside;
  std::vector<std::uint64_t> x_key;
  double z_inside = 0;  // of the row
  std::uint64_t z_key = 0;
};

/// A row's displacements in subvoxels, whole numbers of at most 2^22; and where one octave's positions are
/// then. Padded.
struct DisplacedScratch {
  std::vector<float> east;
  std::vector<float> south;
  std::vector<float> u;                  // 0 to 1 within its cell, eastward
  std::vector<float> v;                  // southward
  std::vector<std::uint32_t> west_hash;  // what the cell's sides add to the hashes of its corners
  std::vector<std::uint32_t> east_hash;
  std::vector<std::uint32_t> north_hash;
  std::vector<std::uint32_t> south_hash;
};

struct DisplacedKernels {
  /// Sums the octaves at `width` columns, displaced by reach_fx times what `east` and `south` say, into out.
  /// `period_fx` is the side of a cell, at most 2^32. Writes up to kPadding further.
  void (*sum)(const DisplacedOctave* octaves, std::size_t count, double period_fx, const float* east,
              const float* south, float reach_fx, std::size_t width, DisplacedScratch& scratch, float* out);
};

[[nodiscard]] const DisplacedKernels& displaced_kernels(InstructionSet set);

}  // namespace talus::terrain
