#include <talus/edits/settle.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <limits>
#include <utility>

#include "visit.h"

namespace talus::edits {
namespace {

static_assert(kSettleRows == 64);
/// Rows of a column; bit 0 is the lowest.
using Rows = std::uint64_t;

bool is_open(MaterialId material) {
  return material == kAir || material == kWater;
}

constexpr Rows row(int y) {
  return Rows{1} << static_cast<unsigned>(y);
}
/// Rows below row y.
constexpr Rows below(int y) {
  return row(y) - 1;
}

struct Column {
  Rows open = 0;
  Rows loose = 0;
  Rows was_ground = 0;
  bool waits = false;  // must be inspected
};

/// Represents rows as bits, so that the cost of an inspection depends on the loose material in the open, not
/// on heights or depths.
class Settler {
 public:
  Settler(const VoxelBox& box, const SettleRules& rules, std::span<SettlingVoxel> voxels)
      : width_{static_cast<int>(box.last.x - box.first.x) + 1},
        rows_{static_cast<int>(box.last.y - box.first.y) + 1},
        depth_{static_cast<int>(box.last.z - box.first.z) + 1},
        rules_{rules},
        voxels_{voxels},
        columns_(static_cast<std::size_t>(width_ * depth_)) {
    assert(rows_ <= kSettleRows);
    assert(voxels.size() == columns_.size() * static_cast<std::size_t>(rows_));
  }

  SettleWork run() {
    read();
    // In a fixed order, independent of the cause.
    while (std::exchange(any_wait_, false) && may_go_on()) {
      std::vector<bool> now(columns_.size());
      for (std::size_t i = 0; i < now.size(); ++i) now[i] = std::exchange(columns_[i].waits, false);
      for (int z = 0; z < depth_; ++z) {
        for (int x = 0; x < width_; ++x) {
          if (now[number(x, z)]) settle_column(x, z);
        }
      }
    }
    return work_;
  }

 private:
  struct Target {
    int x = 0;
    int y = 0;
    int z = 0;
  };

  [[nodiscard]] std::size_t number(int x, int z) const { return static_cast<std::size_t>(z * width_ + x); }
  Column& column(int x, int z) { return columns_[number(x, z)]; }
  SettlingVoxel& at(int x, int y, int z) {
    return voxels_[static_cast<std::size_t>(y) * columns_.size() + number(x, z)];
  }
  [[nodiscard]] bool may_go_on() const { return work_.moves < kSettleMoves && work_.probes < kSettleProbes; }

  [[nodiscard]] const SettleRule* rule_of(MaterialId material) const {
    const auto rule = std::ranges::lower_bound(rules_, material, {}, &SettleRule::material);
    return rule == rules_.end() || rule->material != material ? nullptr : &*rule;
  }

  void read() {
    std::vector<bool> edited(columns_.size());
    auto voxel = voxels_.begin();
    for (int y = 0; y < rows_; ++y) {
      for (std::size_t i = 0; i < columns_.size(); ++i, ++voxel) {
        if (is_open(voxel->now)) {
          columns_[i].open |= row(y);
        } else if (rule_of(voxel->now) != nullptr) {
          columns_[i].loose |= row(y);
        }
        if (!is_open(voxel->base)) columns_[i].was_ground |= row(y);
        if (voxel->edited) edited[i] = true;
      }
    }
    for (int z = 0; z < depth_; ++z) {
      for (int x = 0; x < width_; ++x) {
        if (edited[number(x, z)]) set_around(x, z);
      }
    }
  }

  void set_around(int x, int z) {
    constexpr int kReach = kSettleReach;
    for (int each_z = std::max(0, z - kReach); each_z <= std::min(depth_ - 1, z + kReach); ++each_z) {
      for (int each_x = std::max(0, x - kReach); each_x <= std::min(width_ - 1, x + kReach); ++each_x) {
        column(each_x, each_z).waits = true;
      }
    }
    any_wait_ = true;
  }

  /// From the bottom up, so that material comes down on material already at rest.
  void settle_column(int x, int z) {
    ++work_.probes;
    const Column& column = this->column(x, z);
    for (int y = 0; y + 1 < rows_ && may_go_on();) {
      const Rows over_room = column.loose & (column.open << 1U);
      const Rows in_the_open = column.loose & (column.open >> 1U) & ~(column.open << 1U);
      const Rows left = (over_room | in_the_open) & ~below(y + 1) & ~row(0);
      if (left == 0) return;
      y = std::countr_zero(left);
      ++work_.probes;
      if ((over_room & row(y)) != 0) {
        if (const auto to = fall(x, y, z)) move({x, y, z}, *to);
      } else if (const auto to = slide(x, y, z)) {
        move({x, y, z}, *to);
      }
    }
  }

  /// The lowest row of the open voxels from row y downwards; nullopt if they reach the bottom of the box,
  /// below which voxels are unknown.
  static std::optional<int> floor_from(const Column& column, int y) {
    const Rows ground = ~column.open & (below(y) | row(y));
    if (ground == 0) return std::nullopt;
    return static_cast<int>(std::bit_width(ground));
  }

  std::optional<Target> fall(int x, int y, int z) {
    const Column& here = column(x, z);
    const Rows pair = here.was_ground >> static_cast<unsigned>(y - 1);
    if ((pair & 3U) == 2U) return std::nullopt;  // generated like this
    const auto floor = floor_from(here, y - 1);
    if (!floor) return std::nullopt;
    return Target{x, *floor, z};
  }

  /// Returns the steepest target within kSettleReach columns. Only material in the open slides.
  std::optional<Target> slide(int x, int y, int z) {
    static constexpr std::array<std::array<int, 2>, 8> kDirections{
        {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}};
    const std::int64_t rise = rule_of(at(x, y, z).now)->rise;
    const bool was_ground = (column(x, z).was_ground & row(y)) != 0;
    std::array<bool, kDirections.size()> free{};  // the way there is open
    free.fill(true);
    std::optional<Target> best;
    std::int64_t most = 0;
    for (int distance = 1; distance <= kSettleReach; ++distance) {
      for (std::size_t i = 0; i < kDirections.size(); ++i) {
        const int to_x = x + kDirections[i][0] * distance;
        const int to_z = z + kDirections[i][1] * distance;
        free[i] = free[i] && to_x >= 0 && to_x < width_ && to_z >= 0 && to_z < depth_ &&
                  (column(to_x, to_z).open & row(y)) != 0;
        if (!free[i]) continue;
        const Column& there = column(to_x, to_z);
        const auto floor = floor_from(there, y);
        if (!floor) continue;
        // A step of one voxel is not a slope: land consists of steps.
        const std::int64_t over = std::int64_t{y - *floor} * SettleRule::kUnit - rise * distance;
        if (over <= most) continue;
        const Rows room = (below(y) | row(y)) & ~below(*floor);
        if (was_ground && (there.was_ground & room) == 0) continue;  // generated like this
        most = over;
        best = Target{to_x, *floor, to_z};
      }
    }
    return best;
  }

  void move(const Target& from, const Target& to) {
    // The voxel is replaced by what is above: water or air.
    const bool under_water = from.y + 1 < rows_ && at(from.x, from.y + 1, from.z).now == kWater;
    at(to.x, to.y, to.z).now = std::exchange(at(from.x, from.y, from.z).now, under_water ? kWater : kAir);
    Column& left = column(from.x, from.z);
    left.loose &= ~row(from.y);
    left.open |= row(from.y);
    Column& reached = column(to.x, to.z);
    reached.open &= ~row(to.y);
    reached.loose |= row(to.y);
    set_around(from.x, from.z);
    set_around(to.x, to.z);
    ++work_.moves;
  }

  int width_;
  int rows_;
  int depth_;
  const SettleRules& rules_;
  std::span<SettlingVoxel> voxels_;
  std::vector<Column> columns_;
  bool any_wait_ = false;
  SettleWork work_;
};

}  // namespace

std::optional<VoxelBox> settle_box(const Edit& edit) {
  constexpr auto kMaxCoordinate = std::numeric_limits<std::int64_t>::max();
  VoxelBox box{{kMaxCoordinate, kMaxCoordinate, kMaxCoordinate},
               {-kMaxCoordinate, -kMaxCoordinate, -kMaxCoordinate}};
  const auto add = [&](VoxelPos first, VoxelPos last) {
    box.first = {std::min(box.first.x, first.x), std::min(box.first.y, first.y),
                 std::min(box.first.z, first.z)};
    box.last = {std::max(box.last.x, last.x), std::max(box.last.y, last.y), std::max(box.last.z, last.z)};
  };
  for (const VoxelWrite& each : edit.writes) add(each.voxel, each.voxel);
  for (const Fill& each : edit.fills) add(each.first, each.last);
  if (edit.paste) add(edit.paste->origin, last_of(*edit.paste));
  if (box.first.x > box.last.x) return std::nullopt;  // guards only

  const std::int64_t width = box.last.x - box.first.x + 1;
  const std::int64_t depth = box.last.z - box.first.z + 1;
  const std::int64_t spare = kSettleRows - (box.last.y - box.first.y + 1);
  if (width > kSettleColumns || depth > kSettleColumns || spare < 0) return std::nullopt;
  std::int64_t margin = kSettleMargin;
  while (margin > 0 && (width + 2 * margin) * (depth + 2 * margin) > kSettleColumns) --margin;
  if (margin == 0) return std::nullopt;
  // Material comes down from above; below, only room to fall is needed.
  const std::int64_t below = spare / 3;
  box.first = {box.first.x - margin, box.first.y - below, box.first.z - margin};
  box.last = {box.last.x + margin, box.last.y + (spare - below), box.last.z + margin};
  if (!chunk_holding(box.first, Lod{}) || !chunk_holding(box.last, Lod{})) return std::nullopt;
  return box;
}

SettleWork settle(const VoxelBox& box, const SettleRules& rules, std::span<SettlingVoxel> voxels) {
  return Settler{box, rules, voxels}.run();
}

}  // namespace talus::edits
