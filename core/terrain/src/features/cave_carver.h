// Keeps of a cave's shape what leaves nothing hanging (docs/DESIGN.md, "Caves"). Private to core/terrain.
#pragma once

#include <cstdint>
#include <vector>

#include <talus/terrain/cave_air.h>
#include <talus/terrain/field.h>
#include <talus/terrain/world.h>

#include "feature.h"
#include "features/cave_plan.h"
#include "features/cave_shape.h"

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
  /// Solid from below up to the rock's top; with a roof that is thick enough; with one that is not.
  enum class Kind : std::uint8_t { solid, roofed, open };

  /// Columns of a row outside which all are solid.
  struct Hollow {
    int first = 0;
    int last = 0;  // exclusive
  };

  [[nodiscard]] Hollow thick_enough(int z, const Field& height) const;
  void judge_all(const Field& height);
  void judge_row(int z, const Field& height);
  void find_entrances();
  [[nodiscard]] bool all_dry(int z) const;
  void judge(int x, int z, const Field& height);
  void find_carried();
  /// How far a roof is from what carries it, along one line of columns: the next column's distance from this
  /// one's.
  [[nodiscard]] int carry(std::size_t from, int distance, std::size_t to) const;
  [[nodiscard]] std::size_t index(int x, int z) const {
    return static_cast<std::size_t>(z) * static_cast<std::size_t>(floor_.width) + static_cast<std::size_t>(x);
  }

  CavePlan plan_;
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
  bool shore_near_ = false;      // of the row that is judged
  bool any_ = false;
  bool pending_ = false;
  int next_ = 0;  // row of floors and roofs that is not computed yet
  std::vector<std::int64_t> xs_;
  // Over the judged columns.
  Field floor_;
  Field roof_;
  Field roof_row_;  // of roofed columns; far below in solid ones
  Field rock_row_;  // where solid rock surely ends; far below in open ones
  std::vector<Kind> kinds_;
  std::vector<std::uint8_t> carried_;
  std::vector<std::uint8_t> airy_;  // rows that have air before they are judged
  std::vector<Hollow> hollows_;
  std::vector<std::int32_t> lowest_;  // ground of each row of heights, at level 0; where there is a shore
  std::vector<int> distances_;        // of a row
  Field surface_;                     // of the level, over the judged columns
  Field entrances_;                   // over region_.expanded(open_ring_)
};

}  // namespace talus::terrain
