#include "diamond_square.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <talus/terrain/lattice_hash.h>

namespace talus::tools {
namespace {

constexpr int kFirstPoints = 4;  // along each side of the first grid, so that a tile has several summits
constexpr std::int64_t kFirstReach = std::int64_t{1} << 32;
constexpr int kRoughnessBits = 16;

// Heights on a torus.
class TorusHeights {
 public:
  TorusHeights(std::uint64_t seed, int side)
      : seed_{seed}, side_{side}, heights_(static_cast<std::size_t>(side) * static_cast<std::size_t>(side)) {}

  void start(int spacing) {
    over_grid(0, 0, spacing, [&](int x, int z) { at(x, z) = displacement(x, z, kFirstReach); });
  }

  // Adds a point in the middle of each square of the grid, then one in the middle of each resulting diamond:
  // a grid of half the spacing.
  void refine(int spacing, std::int64_t reach) {
    const int half = spacing / 2;
    over_grid(half, half, spacing, [&](int x, int z) {
      const std::int64_t corners =
          at(x - half, z - half) + at(x + half, z - half) + at(x - half, z + half) + at(x + half, z + half);
      at(x, z) = middle(corners) + displacement(x, z, reach);
    });
    const auto in_diamond = [&](int x, int z) {
      const std::int64_t corners = at(x - half, z) + at(x + half, z) + at(x, z - half) + at(x, z + half);
      at(x, z) = middle(corners) + displacement(x, z, reach);
    };
    over_grid(half, 0, spacing, in_diamond);
    over_grid(0, half, spacing, in_diamond);
  }

  [[nodiscard]] std::vector<std::uint16_t> samples() const {
    const auto [lowest, highest] = std::minmax_element(heights_.begin(), heights_.end());
    const std::int64_t range = std::max<std::int64_t>(1, *highest - *lowest);
    std::vector<std::uint16_t> samples;
    samples.reserve(heights_.size());
    for (const std::int64_t height : heights_) {
      samples.push_back(static_cast<std::uint16_t>(((height - *lowest) * 65535 + range / 2) / range));
    }
    return samples;
  }

 private:
  template <class Visit>
  void over_grid(int first_x, int first_z, int spacing, const Visit& visit) const {
    for (int z = first_z; z < side_; z += spacing) {
      for (int x = first_x; x < side_; x += spacing) visit(x, z);
    }
  }

  [[nodiscard]] std::int64_t& at(int x, int z) {
    const auto wrapped = [&](int i) { return static_cast<std::size_t>(i & (side_ - 1)); };
    return heights_[wrapped(z) * static_cast<std::size_t>(side_) + wrapped(x)];
  }

  static std::int64_t middle(std::int64_t sum_of_four) { return (sum_of_four + 2) >> 2; }

  // From -reach to reach. Depends only on the position, so the order of visits does not matter.
  [[nodiscard]] std::int64_t displacement(int x, int z, std::int64_t reach) const {
    using terrain::derived_seed;
    const std::uint64_t column = derived_seed(seed_, static_cast<std::uint64_t>(x));
    const std::uint64_t draw = derived_seed(column, static_cast<std::uint64_t>(z)) >> 36;  // 28 bits
    return ((static_cast<std::int64_t>(draw) * (2 * reach + 1)) >> 28) - reach;
  }

  std::uint64_t seed_;
  int side_;
  std::vector<std::int64_t> heights_;
};

}  // namespace

terrain::HeightMap diamond_square(const DiamondSquareOptions& options) {
  const auto share = static_cast<std::int64_t>(std::floor(options.roughness * (1 << kRoughnessBits) + 0.5));
  TorusHeights heights{options.seed, options.side};
  int spacing = options.side / kFirstPoints;
  heights.start(spacing);
  for (std::int64_t reach = kFirstReach; spacing > 1; spacing /= 2) {
    reach = (reach * share) >> kRoughnessBits;
    heights.refine(spacing, reach);
  }
  terrain::HeightMap map;
  map.width = options.side;
  map.depth = options.side;
  map.samples = heights.samples();
  return map;
}

}  // namespace talus::tools
