// fBm at displaced positions, one row at a time: the noise of warped surfaces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <talus/vectors/instruction_set.h>

namespace talus::terrain {

/// One octave of a row. Positions are in subvoxels of the octave; the undisplaced position of column i lies
/// x_inside[i] into the cell with key x_key[i] (lattice_hash.h). Padded.
struct DisplacedOctave {
  float weight = 0;
  double frequency = 0;  // 2^k: factor of a displacement
  std::vector<double> x_inside;
  std::vector<std::uint64_t> x_key;
  double z_inside = 0;  // the row's position in its cell
  std::uint64_t z_key = 0;
};

/// A row's displacements in subvoxels, integers of at most 2^22, and the positions in one octave. Padded.
struct DisplacedScratch {
  std::vector<float> east;
  std::vector<float> south;
  std::vector<float> u;                  // position in its cell, 0 to 1 eastward
  std::vector<float> v;                  // position in its cell, 0 to 1 southward
  std::vector<std::uint32_t> west_hash;  // the cell sides' contributions to the hashes of its corners
  std::vector<std::uint32_t> east_hash;
  std::vector<std::uint32_t> north_hash;
  std::vector<std::uint32_t> south_hash;
};

struct DisplacedKernels {
  /// Sums the octaves at `width` columns, displaced by reach_fx times `east` and `south`, into out.
  /// `period_fx` is the side of a cell, at most 2^32. May write kPadding elements past the end.
  void (*sum)(const DisplacedOctave* octaves, std::size_t count, double period_fx, const float* east,
              const float* south, float reach_fx, std::size_t width, DisplacedScratch& scratch, float* out);
};

[[nodiscard]] const DisplacedKernels& displaced_kernels(InstructionSet set);

}  // namespace talus::terrain
