// Caves of a world. Private to core/terrain.
#pragma once

#include "feature.h"
#include "features/cave_plan.h"

namespace talus::terrain {

/// [caves]: tunnels and chambers that leave no rock hanging.
class Caves final : public Feature {
 public:
  Caves(const CavePlan& plan, bool has_sea) : plan_{plan}, has_sea_{has_sea} {}

  [[nodiscard]] const CavePlan& plan() const { return plan_; }

  void write_canonical_form(TextWriter& form) const override;
  [[nodiscard]] int halo(Lod lod) const override;
  [[nodiscard]] bool carves() const override { return true; }
  [[nodiscard]] std::unique_ptr<Carver> make_carver(const World& world, InstructionSet set) const override;
  void add_overlays(const ChunkSite& site, const Field* survey,
                    std::vector<Overlay>& overlays) const override;

 private:
  CavePlan plan_;
  bool has_sea_;
};

}  // namespace talus::terrain
