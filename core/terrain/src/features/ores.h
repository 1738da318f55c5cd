// Ores in the numbers they are made with. Private to core/terrain.
#pragma once

#include <utility>
#include <vector>

#include "feature.h"
#include "features/ore_bodies.h"

namespace talus::terrain {

/// [[veins]]: ore in bodies of which each lies wholly between two heights. It takes the place of rock alone.
class Ores final : public Feature {
 public:
  explicit Ores(std::vector<OreKind> kinds) : kinds_{std::move(kinds)} {}

  /// In the order of the spec.
  [[nodiscard]] const std::vector<OreKind>& kinds() const { return kinds_; }

  void write_canonical_form(std::ostream& form) const override;
  [[nodiscard]] OverlayRows overlay_rows(Lod lod) const override;
  void add_overlays(const ChunkSite& site, const Field* survey,
                    std::vector<Overlay>& overlays) const override;
  void add_exposed(const Stacks& stacks, const Field* survey, std::span<MaterialId> exposed) const override;

 private:
  std::vector<OreKind> kinds_;
};

}  // namespace talus::terrain
