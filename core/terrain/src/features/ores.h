// Ores in the numbers used to compute them. Private to core/terrain.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include <talus/terrain/secret.h>

#include "feature.h"
#include "features/ore_bodies.h"

namespace talus::terrain {

/// [[veins]]: ore in bodies, each completely between two heights. It replaces only rock.
class Ores final : public Feature {
 public:
  /// `view` counts for secret kinds: all are, or none is.
  explicit Ores(std::vector<OreKind> kinds, SecretView view = SecretView::everything)
      : kinds_{std::move(kinds)}, view_{view} {}

  /// In the order of the spec.
  [[nodiscard]] const std::vector<OreKind>& kinds() const { return kinds_; }

  void write_canonical_form(TextWriter& form) const override;
  [[nodiscard]] OverlayRows overlay_rows(Lod lod) const override;
  void add_overlays(const ChunkSite& site, const Field* survey,
                    std::vector<Overlay>& overlays) const override;
  void add_exposed(const Stacks& stacks, const Field* survey, std::span<MaterialId> exposed) const override;
  [[nodiscard]] std::shared_ptr<const Feature> kept_secret(const SipHash& draw,
                                                           SecretView view) const override;
  [[nodiscard]] bool add_secret(ChunkCoord chunk, std::span<MaterialId, kChunkVolume> voxels) const override;

 private:
  std::vector<OreKind> kinds_;
  SecretView view_;
};

}  // namespace talus::terrain
