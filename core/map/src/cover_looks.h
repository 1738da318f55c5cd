// Computes a column's colour from its own quantities, without the stacks around it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <talus/terrain/places_spec.h>
#include <talus/terrain/world.h>
#include <talus/voxel/material.h>
#include <glm/vec3.hpp>

#include <talus/map/column_grid.h>

namespace talus::map {

/// Colours of the cover and of water: looks, and shares of loose material, for ground of a given slope.
/// Assumes that no wall is near: from afar no wall is as wide as a pixel.
class CoverLooks {
 public:
  explicit CoverLooks(const terrain::World& world);

  /// Names that sample_columns() must sample.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  /// The colour of level ground, as light, at one column of the samples. Its rock is the topmost layer.
  [[nodiscard]] glm::vec3 level_ground(const ColumnSamples& samples, std::size_t column) const;
  /// The colour of ground with a slope in subvoxels per column. Its rock is the layer at that height, for
  /// even layers.
  [[nodiscard]] glm::vec3 ground(const ColumnSamples& samples, std::size_t column,
                                 std::int32_t slope_fx) const;
  /// The colour of the sea over the column, or of its ice.
  [[nodiscard]] glm::vec3 water(const ColumnSamples& samples, std::size_t column) const;

 private:
  struct Cover {
    MaterialId material{};
    float thickness_voxels = 0;  // on level ground
    std::int32_t steepest_fx = 0;
    std::optional<std::size_t> share;
  };

  void need(terrain::QuantityNumber quantity);
  /// A column of the samples, and its slope.
  struct Place {
    const ColumnSamples& samples;
    std::size_t column = 0;
    std::int32_t slope_fx = 0;
  };
  [[nodiscard]] float value(const Place& place, terrain::QuantityNumber quantity) const;
  [[nodiscard]] MaterialId shown(const Place& place, MaterialId material) const;
  [[nodiscard]] float voxels_of(const Place& place, const Cover& cover) const;
  [[nodiscard]] glm::vec3 covered(const Place& place, MaterialId rock) const;
  [[nodiscard]] MaterialId rock_at(std::int32_t height_fx) const;

  const terrain::World& world_;
  std::vector<glm::vec3> lights_;
  std::vector<Cover> covers_;                // top down
  std::vector<std::int64_t> layer_tops_fx_;  // tops of World::strata() at their mean thicknesses
  std::vector<std::string> names_;
  std::vector<std::optional<std::size_t>> place_of_;  // index in names_, by quantity
};

}  // namespace talus::map
