// What covers a column, told from its quantities alone, without the stacks of its neighbourhood.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <talus/terrain/places_spec.h>
#include <talus/terrain/world.h>
#include <talus/voxel/material.h>
#include <glm/vec3.hpp>

#include "column_grid.h"

namespace talus::tools {

/// The looks of the cover, of other loose material and of water, and the shares of loose material, as though
/// the ground were level: from afar no wall is as wide as a pixel.
class CoverLooks {
 public:
  explicit CoverLooks(const terrain::World& world);

  /// What sample_columns() must give.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  /// The colour of level ground, as light, at one column of the samples.
  [[nodiscard]] glm::vec3 ground(const ColumnSamples& samples, std::size_t column) const;
  /// Of the sea over it, or its ice.
  [[nodiscard]] glm::vec3 water(const ColumnSamples& samples, std::size_t column) const;

 private:
  struct Cover {
    MaterialId material{};
    float thickness_voxels = 0;
    std::optional<std::size_t> share;
  };

  void need(terrain::QuantityNumber quantity);
  [[nodiscard]] float value(const ColumnSamples& samples, terrain::QuantityNumber quantity,
                            std::size_t column) const;
  [[nodiscard]] MaterialId shown(const ColumnSamples& samples, MaterialId material, std::size_t column) const;
  [[nodiscard]] float voxels_of(const ColumnSamples& samples, const Cover& cover, std::size_t column) const;

  const terrain::World& world_;
  std::vector<glm::vec3> lights_;
  std::vector<Cover> covers_;  // top down
  std::vector<std::string> names_;
  std::vector<std::optional<std::size_t>> place_of_;  // in names_, by quantity
};

}  // namespace talus::tools
