// Paints the world from above, as generated or with edits: materials under the sun's light.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <talus/map/edited_tops.h>
#include <talus/map/image.h>
#include <talus/map/painting.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/world.h>
#include <glm/vec3.hpp>

namespace talus::map {

class WaterLight;

/// Paints one pixel per column of a level. A pixel's colour is the mean of the topmost base voxel of its
/// stack, so rock shows through thin soil, and the sea's bed through shallow water. Thread-safe.
class RegionPainter {
 public:
  /// `relief`: factor for heights when shading. `edits`: null to paint the land as generated. `world` and
  /// `edits` must outlive this.
  RegionPainter(const terrain::World& world, Lod lod, float relief = 1, const EditedTops* edits = nullptr);
  ~RegionPainter();

  /// Paints the patch into the image from pixel (x, y) on, north (low z) at the top. `generator` must be of
  /// the same world; it, the image and this must outlive the painting.
  [[nodiscard]] std::unique_ptr<Painting> start(terrain::Generator& generator, const terrain::Region& patch,
                                                Image& image, int x, int y) const;

 private:
  class Work;
  struct Scene;
  [[nodiscard]] Scene scene_of(terrain::Stacks stacks) const;
  void apply_edits(Scene& scene) const;
  [[nodiscard]] glm::vec3 pixel(const Scene& scene, int x, int z) const;
  [[nodiscard]] MaterialId water_at(const terrain::Stacks& stacks, int x, int z) const;

  const terrain::World& world_;
  const Lod lod_;
  const float relief_;
  const EditedTops* const edits_;
  std::vector<glm::vec3> lights_;
  std::unique_ptr<const WaterLight> water_;
  std::optional<std::int32_t> sea_fx_;
};

}  // namespace talus::map
