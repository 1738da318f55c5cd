// fBm at positions between columns, one after another; displaced_fbm.h has rows of them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <talus/terrain/fbm.h>

namespace talus::terrain {

/// The same lattice and corners as FbmRows has; its numbers agree with those to rounding, not to the bit.
/// For one thread at a time.
class PointFbm {
 public:
  explicit PointFbm(const Fbm& fbm);

  /// The noise at a position in subvoxels, |position| <= 2^45. A pure function of it; positions close to the
  /// one before cost least. Positions are integers, so that the far ends of the world are as fine as its
  /// middle.
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
    bool drawn = false;               // whether the gradients are those of the cell
    std::array<float, 4> gradient_x;  // of the corners NW, NE, SW, SE
    std::array<float, 4> gradient_z;
  };

  /// Whether the place is in another cell than before.
  bool move(Place& place, std::int64_t position) const;
  static void draw(Octave& octave);

  std::int64_t period_fx_;
  float reciprocal_;
  std::vector<Octave> octaves_;
};

}  // namespace talus::terrain
