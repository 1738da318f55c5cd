#include <talus/terrain/slope.h>

#include <algorithm>
#include <cstdlib>

namespace talus::terrain {

Field slope_inside(const Field& heights) {
  Field slope{heights.width - 2, heights.depth - 2};
  for (int z = 0; z < slope.depth; ++z) {
    const std::int32_t* north = heights.row(z).data();
    const std::int32_t* own = heights.row(z + 1).data();
    const std::int32_t* south = heights.row(z + 2).data();
    std::int32_t* out = slope.row(z).data();
    for (int x = 0; x < slope.width; ++x) {
      // The greatest difference is toward the lowest or the highest of the nine.
      const std::int32_t low = std::min(
          {north[x], north[x + 1], north[x + 2], own[x], own[x + 2], south[x], south[x + 1], south[x + 2]});
      const std::int32_t high = std::max(
          {north[x], north[x + 1], north[x + 2], own[x], own[x + 2], south[x], south[x + 1], south[x + 2]});
      const std::int32_t h = own[x + 1];
      out[x] = std::max({h - low, high - h, 0});
    }
  }
  return slope;
}

}  // namespace talus::terrain
