// Keeps of a cave's shape what leaves nothing hanging (docs/DESIGN.md, "Caves"). Private to core/terrain.
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

  /// Where there is a sea, the columns beside a column decide whether it may open to the sky.
  [[nodiscard]] int entrance_halo(Lod lod) const override { return plan_.span_at(lod) == 0 ? 0 : shore_; }
  /// With less around than Caves::halo() some roofs that hold are taken for unsafe.
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
  std::int32_t loose_fx_ = 0;    // all that can be loose, at the region's level
  std::int32_t least_rows_ = 0;  // of a roof that holds
  std::int32_t least_fx_ = 0;    // where less ground than that stands, all is solid
  bool any_ = false;
  bool pending_ = false;
  int next_ = 0;  // row of floors and roofs that is not computed yet
  std::vector<std::int64_t> xs_;
  // Over the judged columns.
  Field floor_;
  Field roof_;
  Field roof_row_;  // JudgedRows says what these are
  Field rock_row_;
  std::vector<std::uint8_t> airy_;    // rows that have air before they are judged
  std::vector<std::int32_t> lowest_;  // ground of each row of heights, at level 0; where there is a shore
  CarriedRoofs roofs_;
  Field entrances_;  // over region_.expanded(open_ring_)
};

}  // namespace talus::terrain
