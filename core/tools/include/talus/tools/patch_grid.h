// Divides a region into patches that are generated one by one, so that memory does not grow with the region.
#pragma once

#include <cstddef>

#include <talus/terrain/field.h>

namespace talus::tools {

/// Squares of `edge` columns from the region's origin, z slowest, then x. If `edge` does not divide the
/// region, the last patch of each row and column is smaller.
class PatchGrid {
 public:
  PatchGrid(const terrain::Region& region, int edge);

  [[nodiscard]] std::size_t count() const { return across_ * down_; }
  [[nodiscard]] std::size_t across() const { return across_; }
  [[nodiscard]] terrain::Region patch(std::size_t index) const;
  [[nodiscard]] const terrain::Region& region() const { return region_; }

 private:
  terrain::Region region_;
  int edge_;
  std::size_t across_;
  std::size_t down_;
};

}  // namespace talus::tools
