// Removes the parts of a cave's shape that would leave rock hanging (docs/DESIGN.md, "Caves"). Private to
// core/terrain.
#pragma once

#include <cstdint>
#include <vector>

#include <talus/terrain/cave_air.h>
#include <talus/terrain/field.h>
#include <talus/terrain/world.h>

#include "feature.h"
#include "features/carried_roofs.h"
#include "features/cave_plan.h"
#include "features/cave_shape.h"
#include "kernels/caves.h"

namespace talus::terrain {

/// The world must outlive it.
class CaveCarver final : public Carver {
 public:
  CaveCarver(const CavePlan& plan, const World& world, InstructionSet set);

  /// With a sea, the adjacent columns decide whether a column may open to the sky.
  [[nodiscard]] int entrance_halo(Lod lod) const override { return plan_.span_at(lod) == 0 ? 0 : shore_; }
  /// With less around than Caves::halo(), some roofs that hold are considered unsafe.
  void start(const Region& region, int around, int open_ring) override;
  [[nodiscard]] bool pending() const override { return pending_; }
  void compute_rows(int count, const Field& height) override;
  [[nodiscard]] const Field& entrances() const override { return entrances_; }
  void take(CaveAir& air) const override;

 private:
  [[nodiscard]] ColumnRange thick_enough(int z, const Field& height) const;
  void judge_all(const Field& height);
  void judge_row(int z, const Field& height);
  void find_touching(int z);
  [[nodiscard]] bool all_dry(int z) const;
  void find_entrances();

  CavePlan plan_;
  const CaveKernels& kernels_;
  CaveShape shape_;
  int shore_ = 0;
  std::int32_t sea_fx_ = 0;
  bool erodes_ = false;
  std::vector<std::int32_t> loose_thickness_fx_;

  Region region_;
  int judged_ = 0;  // columns around the region that are judged
  int open_ring_ = 0;
  int span_ = 0;
  std::int32_t loose_fx_ = 0;  // total thickness of loose material, at the region's level
  std::int32_t min_rows_ = 0;  // minimum rows of a roof that holds
  std::int32_t min_fx_ = 0;    // columns with less ground are solid
  bool any_ = false;
  bool pending_ = false;
  int next_ = 0;  // next row of floors and roofs to compute
  std::vector<std::int64_t> xs_;
  // Over the judged columns.
  Field floor_;
  Field roof_;
  Field roof_row_;  // see JudgedRows
  Field rock_row_;
  std::vector<std::uint8_t> airy_;    // by row: 1 if it has air before it is judged
  std::vector<std::int32_t> lowest_;  // lowest ground of each row of heights, at level 0; only with a shore
  CarriedRoofs roofs_;
  Field entrances_;  // over region_.expanded(open_ring_)
};

}  // namespace talus::terrain
