// Ores in the numbers used to compute them. Private to core/terrain.
#pragma once

#include <utility>
#include <vector>

#include "feature.h"
#include "features/ore_bodies.h"

namespace talus::terrain {

/// [[veins]]: ore in bodies, each completely between two heights. It replaces only rock.
class Ores final : public Feature {
 public:
  explicit Ores(std::vector<OreKind> kinds) : kinds_{std::move(kinds)} {}

  /// In the order of the spec.
  [[nodiscard]] const std::vector<OreKind>& kinds() const { return kinds_; }

  void write_canonical_form(TextWriter& form) const override;
  [[nodiscard]] OverlayRows overlay_rows(Lod lod) const override;
  void add_overlays(const ChunkSite& site, const Field* survey,
                    std::vector<Overlay>& overlays) const override;
  void add_exposed(const Stacks& stacks, const Field* survey, std::span<MaterialId> exposed) const override;

 private:
  std::vector<OreKind> kinds_;
};

}  // namespace talus::terrain
