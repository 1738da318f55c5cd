// fBm at single positions between columns; displaced_fbm.h computes rows of them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <talus/terrain/fbm.h>

namespace talus::terrain {

/// Uses the lattice and corners of FbmRows; results agree to rounding, not to the bit. Not thread-safe.
class PointFbm {
 public:
  explicit PointFbm(const Fbm& fbm);

  /// The noise at a position in subvoxels, |position| <= 2^45. A pure function of the position; cheapest
  /// close to the previous one. Positions are integers, so precision is the same everywhere in the world.
  [[nodiscard]] float at(std::int64_t x_fx, std::int64_t z_fx);

 private:
  struct Place {
    std::int64_t position = 0;  // in subvoxels of the octave
    std::int64_t cell = 0;
    std::int64_t inside = 0;  // 0 to period_fx_ - 1
  };
  struct Octave {
    std::uint64_t seed = 0;
    float weight = 0;
    std::int64_t x_offset_fx = 0;
    std::int64_t z_offset_fx = 0;
    Place x;
    Place z;
    bool drawn = false;               // true if the gradients belong to the cell
    std::array<float, 4> gradient_x;  // at the corners NW, NE, SW, SE
    std::array<float, 4> gradient_z;
  };

  /// Returns true if the new position is in another cell.
  bool move(Place& place, std::int64_t position) const;
  static void draw(Octave& octave);

  std::int64_t period_fx_;
  float reciprocal_;
  std::vector<Octave> octaves_;
};

}  // namespace talus::terrain
