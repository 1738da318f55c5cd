#include <talus/terrain/settle.h>

#include <algorithm>

namespace talus::terrain {
namespace {

// own = min(own, smallest of the three columns beside it in `other` + c). No column waits for another, so
// this part of a pass runs in vectors.
void lower_from_row(std::int32_t* own, const std::int32_t* other, int width, std::int32_t c) {
  if (width == 1) {
    own[0] = std::min(own[0], other[0] + c);
    return;
  }
  own[0] = std::min(own[0], std::min(other[0], other[1]) + c);
  for (int x = 1; x + 1 < width; ++x) {
    const std::int32_t least = std::min(std::min(other[x - 1], other[x]), other[x + 1]);
    own[x] = std::min(own[x], least + c);
  }
  own[width - 1] = std::min(own[width - 1], std::min(other[width - 2], other[width - 1]) + c);
}

}  // namespace

Field starting_thickness(const Field& slope, std::int32_t thickness_fx, std::int32_t max_slope_fx) {
  Field thickness{slope.width, slope.depth};
  for (std::size_t i = 0; i < slope.values.size(); ++i) {
    const std::int32_t room = max_slope_fx - slope.values[i];
    thickness.values[i] =
        room <= 0 ? 0 : static_cast<std::int32_t>(std::int64_t{thickness_fx} * room / max_slope_fx);
  }
  return thickness;
}

void settle(Field& thickness, std::int32_t repose_fx) {
  const int width = thickness.width;
  for (int z = 0; z < thickness.depth; ++z) {
    std::int32_t* own = thickness.row(z).data();
    if (z > 0) lower_from_row(own, thickness.row(z - 1).data(), width, repose_fx);
    for (int x = 1; x < width; ++x) own[x] = std::min(own[x], own[x - 1] + repose_fx);
  }
  for (int z = thickness.depth - 1; z >= 0; --z) {
    std::int32_t* own = thickness.row(z).data();
    if (z + 1 < thickness.depth) lower_from_row(own, thickness.row(z + 1).data(), width, repose_fx);
    for (int x = width - 2; x >= 0; --x) own[x] = std::min(own[x], own[x + 1] + repose_fx);
  }
}

}  // namespace talus::terrain
