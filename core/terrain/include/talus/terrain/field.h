// Rectangles of columns, and numbers over them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <talus/vectors/aligned.h>
#include <talus/voxel/coords.h>

namespace talus::terrain {

/// Columns x to x + width - 1 and z to z + depth - 1, in columns of `lod`.
struct Region {
  std::int64_t x = 0;
  std::int64_t z = 0;
  int width = 0;  // along x
  int depth = 0;  // along z
  Lod lod;

  [[nodiscard]] std::size_t columns() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(depth);
  }
  /// The region with `ring` more columns on every side.
  [[nodiscard]] Region expanded(int ring) const {
    return {x - ring, z - ring, width + 2 * ring, depth + 2 * ring, lod};
  }
  bool operator==(const Region&) const = default;
};

/// One value per column, z slowest, then x: values[z * width + x].
template <class Value>
struct BasicField {
  using Values = std::vector<Value, UnsetAllocator<Value>>;

  int width = 0;
  int depth = 0;
  Values values;

  BasicField() = default;
  BasicField(int width_, int depth_)
      : width{width_},
        depth{depth_},
        values(static_cast<std::size_t>(width_) * static_cast<std::size_t>(depth_), Value{}) {}

  /// Changes the size; values become unspecified. Keeps the allocation.
  void reshape(int width_, int depth_) {
    width = width_;
    depth = depth_;
    values.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(depth_));
  }

  [[nodiscard]] Value at(int x, int z) const { return values[index(x, z)]; }
  [[nodiscard]] Value& at(int x, int z) { return values[index(x, z)]; }
  [[nodiscard]] std::span<Value> row(int z) {
    return {values.data() + index(0, z), static_cast<std::size_t>(width)};
  }
  [[nodiscard]] std::span<const Value> row(int z) const {
    return {values.data() + index(0, z), static_cast<std::size_t>(width)};
  }
  /// The field without its outermost `ring` columns on every side.
  [[nodiscard]] BasicField cropped(int ring) const;
  /// Copies the cropped field into `inside`, reusing its memory.
  void crop_into(int ring, BasicField& inside) const;

 private:
  [[nodiscard]] std::size_t index(int x, int z) const {
    return static_cast<std::size_t>(z) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

/// Heights, slopes, thicknesses.
using Field = BasicField<std::int32_t>;
/// Look numbers; see places_spec.h.
using LookField = BasicField<std::uint8_t>;

}  // namespace talus::terrain
