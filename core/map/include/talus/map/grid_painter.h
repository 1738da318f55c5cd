// The world from above and from afar: columns many base columns apart.
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

/// Where a pixel's colour comes from.
enum class GridColours : std::uint8_t {
  /// Where columns lie 16 base columns apart or more and the world has looks, that of the look and of the
  /// loose
  /// material of level ground; else the top of the stack in the nearest level of detail, which is generated.
  exact,
  /// That of the look and of the loose material that lies on ground as steep as the column's. Nothing is
  /// generated.
  told_by_slope,
};

/// One pixel a column of a grid. Light falls on the heights of the grid's columns, which stand up the more
/// the farther they lie apart. Any number of threads may paint.
class GridPainter {
 public:
  /// Of grids of columns that far apart. The world outlives this.
  GridPainter(const terrain::World& world, std::int64_t every, GridColours colours = GridColours::exact);
  ~GridPainter();

  /// The grid, into the picture from pixel (x, y) on, north (low z) at the top. The image and this outlive
  /// the painting. REQUIRES that the grid's columns are as far apart as this says.
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
