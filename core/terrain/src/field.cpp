#include <talus/terrain/field.h>

#include <algorithm>

namespace talus::terrain {

Field Field::without_ring(int ring) const {
  Field inner{width - 2 * ring, depth - 2 * ring};
  for (int z = 0; z < inner.depth; ++z) {
    const auto from =
        row(z + ring).subspan(static_cast<std::size_t>(ring), static_cast<std::size_t>(inner.width));
    std::copy(from.begin(), from.end(), inner.row(z).begin());
  }
  return inner;
}

}  // namespace talus::terrain
