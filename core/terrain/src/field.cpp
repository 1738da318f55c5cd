#include <talus/terrain/field.h>

#include <algorithm>

namespace talus::terrain {

template <class Value>
BasicField<Value> BasicField<Value>::cropped(int ring) const {
  BasicField inside;
  crop_into(ring, inside);
  return inside;
}

template <class Value>
void BasicField<Value>::crop_into(int ring, BasicField& inside) const {
  inside.reshape(width - 2 * ring, depth - 2 * ring);
  for (int z = 0; z < inside.depth; ++z) {
    std::copy_n(row(z + ring).begin() + ring, inside.width, inside.row(z).begin());
  }
}

template struct BasicField<std::int32_t>;
template struct BasicField<std::uint8_t>;

}  // namespace talus::terrain
