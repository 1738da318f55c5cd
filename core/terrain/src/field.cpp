#include <talus/terrain/field.h>

#include <algorithm>

namespace talus::terrain {

Field Field::cropped(int ring) const {
  Field inside;
  crop_into(ring, inside);
  return inside;
}

void Field::crop_into(int ring, Field& inside) const {
  inside.reshape(width - 2 * ring, depth - 2 * ring);
  for (int z = 0; z < inside.depth; ++z) {
    std::copy_n(row(z + ring).begin() + ring, inside.width, inside.row(z).begin());
  }
}

}  // namespace talus::terrain
