// Which of the air that a cave's shape asks for may be, so that nothing is left hanging (docs/DESIGN.md,
// "Caves").
#pragma once

#include <cstdint>
#include <vector>

#include <talus/terrain/cave_air.h>
#include <talus/terrain/field.h>
#include <talus/terrain/world.h>

#include "cave_plan.h"
#include "cave_shape.h"

namespace talus::terrain {

/// Keeps its memory from region to region. For one thread at a time; the world, which has caves, must outlive
/// it.
class Caves {
 public:
  Caves(const World& world, InstructionSet set);

  /// Columns beside a column that decide whether it may open to the sky: where there is a sea.
  [[nodiscard]] int shore() const { return shore_; }

  /// `height` is level 0's H over region.grown(around), and must be exact there. Entrances are judged over
  /// region.grown(open_ring), which needs around >= open_ring + shore(). Roofs over the region need
  /// around >= cave_halo(); with less, some that hold are taken for unsafe.
  void cover(const Region& region, int around, int open_ring, const Field& height);

  /// Whether the column is an entrance; counted from the corner of region.grown(open_ring).
  [[nodiscard]] bool opens(int x, int z) const {
    return any_ && kinds_[index(x + judged_ - open_ring_, z + judged_ - open_ring_)] == Kind::open;
  }
  /// The ground there, in subvoxels of the level.
  [[nodiscard]] std::int32_t floor(int x, int z) const {
    return floor_.at(x + judged_ - open_ring_, z + judged_ - open_ring_);
  }

  /// The air over the region.
  void take(CaveAir& air) const;

 private:
  /// Solid from below up to the rock's top; with a roof that is thick enough; with one that is not.
  enum class Kind : std::uint8_t { solid, roofed, open };

  void judge_row(int z, const Field& height);
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
  bool any_ = false;
  std::vector<std::int64_t> xs_;
  // Over the judged columns.
  Field floor_;
  Field roof_;
  Field roof_row_;  // of roofed columns; far below in solid ones
  Field rock_row_;  // where solid rock surely ends; far below in open ones
  std::vector<Kind> kinds_;
  std::vector<std::uint8_t> carried_;
  std::vector<int> distances_;  // of a row
  Field surface_;               // of the level, over the judged columns
};

}  // namespace talus::terrain
