// Paints the world from above and from afar: one pixel per column of a sparse grid.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <talus/map/column_grid.h>
#include <talus/map/image.h>
#include <talus/map/painting.h>
#include <talus/terrain/world.h>
#include <glm/vec3.hpp>

namespace talus::map {

class CoverLooks;
class WaterLight;

/// Source of a pixel's colour.
enum class GridColours : std::uint8_t {
  /// Uses the colour of the column's look and of the loose material on level ground if columns are at least
  /// 16 base columns apart and the world has looks. Otherwise generates the stack at the nearest level.
  exact,
  /// Uses the colour of the column's look and of the loose material that lies on ground as steep as the
  /// column's. Generates nothing.
  told_by_slope,
};

/// Paints one pixel per column of a grid. Shading uses the heights of the grid's columns, exaggerated more
/// the farther apart they are. Any number of threads may paint.
class GridPainter {
 public:
  /// Paints grids whose columns are `every` base columns apart. `world` must outlive this.
  GridPainter(const terrain::World& world, std::int64_t every, GridColours colours = GridColours::exact);
  ~GridPainter();

  /// Paints the grid into the image from pixel (x, y) on, north (low z) at the top. The image and this must
  /// outlive the painting. REQUIRES grid.every == every.
  [[nodiscard]] std::unique_ptr<Painting> start(const ColumnGrid& grid, Image& image, int x, int y) const;

 private:
  class Work;
  enum class Source : std::uint8_t { stacks, level_ground, own_slope };

  [[nodiscard]] std::vector<glm::vec3> tops_of_stacks(const ColumnGrid& grid) const;
  [[nodiscard]] terrain::Field lifted(const terrain::Field& heights_fx, bool sea) const;

  const terrain::World& world_;
  const std::int64_t every_;
  std::unique_ptr<const CoverLooks> looks_;
  Source source_;
  std::vector<glm::vec3> lights_;
  std::unique_ptr<const WaterLight> water_;
};

}  // namespace talus::map
