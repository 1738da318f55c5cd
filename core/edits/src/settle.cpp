#include <talus/edits/settle.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <utility>

#include "visit.h"

namespace talus::edits {
namespace {

bool is_open(MaterialId material) {
  return material == kAir || material == kWater;
}

/// Columns of a box that are to be looked at, in one order whatever set them.
class Columns {
 public:
  Columns(int width, int depth)
      : width_{width}, depth_{depth}, waiting_(static_cast<std::size_t>(width * depth)) {}

  void set_around(int x, int z) {
    constexpr int kReach = kSettleReach;
    for (int each_z = std::max(0, z - kReach); each_z <= std::min(depth_ - 1, z + kReach); ++each_z) {
      for (int each_x = std::max(0, x - kReach); each_x <= std::min(width_ - 1, x + kReach); ++each_x) {
        waiting_[static_cast<std::size_t>(each_z * width_ + each_x)] = true;
        any_ = true;
      }
    }
  }
  [[nodiscard]] bool any() const { return any_; }
  /// All that are set now, and none from here on.
  [[nodiscard]] std::vector<bool> take() {
    any_ = false;
    return std::exchange(waiting_, std::vector<bool>(waiting_.size()));
  }

 private:
  int width_;
  int depth_;
  std::vector<bool> waiting_;
  bool any_ = false;
};

class Settling {
 public:
  Settling(const VoxelBox& box, const SettleRules& rules, std::span<SettlingVoxel> voxels)
      : width_{static_cast<int>(box.last.x - box.first.x) + 1},
        rows_{static_cast<int>(box.last.y - box.first.y) + 1},
        depth_{static_cast<int>(box.last.z - box.first.z) + 1},
        rules_{rules},
        voxels_{voxels},
        columns_{width_, depth_} {
    assert(voxels.size() == static_cast<std::size_t>(width_ * rows_ * depth_));
  }

  int run() {
    for (int y = 0; y < rows_; ++y) {
      for (int z = 0; z < depth_; ++z) {
        for (int x = 0; x < width_; ++x) {
          if (at(x, y, z).edited) columns_.set_around(x, z);
        }
      }
    }
    while (columns_.any() && moves_ < kSettleMoves) {
      const std::vector<bool> now = columns_.take();
      for (int z = 0; z < depth_; ++z) {
        for (int x = 0; x < width_; ++x) {
          if (now[static_cast<std::size_t>(z * width_ + x)]) settle_column(x, z);
        }
      }
    }
    return moves_;
  }

 private:
  struct Target {
    int x = 0;
    int y = 0;
    int z = 0;
  };

  SettlingVoxel& at(int x, int y, int z) {
    return voxels_[static_cast<std::size_t>((y * depth_ + z) * width_ + x)];
  }
  bool open(int x, int y, int z) { return is_open(at(x, y, z).now); }
  bool was_ground(int x, int y, int z) { return !is_open(at(x, y, z).base); }

  [[nodiscard]] const SettleRule* rule_of(MaterialId material) const {
    const auto rule = std::ranges::lower_bound(rules_, material, {}, &SettleRule::material);
    return rule == rules_.end() || rule->material != material ? nullptr : &*rule;
  }

  /// From the bottom up, so that what is above comes down on what has come to rest.
  void settle_column(int x, int z) {
    for (int y = 1; y < rows_; ++y) {
      const SettleRule* const rule = rule_of(at(x, y, z).now);
      if (rule == nullptr) continue;
      if (moves_ == kSettleMoves) return;
      if (const auto below = fall(x, y, z)) {
        move({x, y, z}, *below);
      } else if (const auto down = slide(x, y, z, rule->rise)) {
        move({x, y, z}, *down);
      }
    }
  }

  /// The lowest of the open voxels from (x, y, z) downwards; none where they reach the bottom of the box,
  /// below which nobody looks.
  std::optional<int> floor_from(int x, int y, int z) {
    while (y >= 0 && open(x, y, z)) --y;
    if (y < 0) return std::nullopt;
    return y + 1;
  }

  std::optional<Target> fall(int x, int y, int z) {
    if (!open(x, y - 1, z)) return std::nullopt;
    if (was_ground(x, y, z) && !was_ground(x, y - 1, z)) return std::nullopt;  // so it was generated
    const auto floor = floor_from(x, y - 1, z);
    if (!floor) return std::nullopt;
    return Target{x, *floor, z};
  }

  /// Where it is steepest, as measured over one column to kSettleReach. Only what lies open slides.
  std::optional<Target> slide(int x, int y, int z, std::int32_t rise) {
    if (y + 1 == rows_ || !open(x, y + 1, z) || open(x, y - 1, z)) return std::nullopt;
    static constexpr std::array<std::array<int, 2>, 8> kDirections{
        {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}};
    std::optional<Target> best;
    std::int64_t most = 0;
    for (int distance = 1; distance <= kSettleReach; ++distance) {
      for (const auto& direction : kDirections) {
        if (!is_free(x, y, z, direction, distance)) continue;
        const int to_x = x + direction[0] * distance;
        const int to_z = z + direction[1] * distance;
        const auto floor = floor_from(to_x, y, to_z);
        if (!floor) continue;
        // A step of one voxel is no slope: the land is made of steps.
        const std::int64_t over =
            std::int64_t{y - *floor} * SettleRule::kUnit - std::int64_t{rise} * distance;
        if (over <= most) continue;
        if (was_ground(x, y, z) && !any_was_ground(to_x, *floor, y, to_z)) continue;  // so it was generated
        most = over;
        best = Target{to_x, *floor, to_z};
      }
    }
    return best;
  }

  /// Whether a voxel at row y can go so far: all between is open there.
  bool is_free(int x, int y, int z, const std::array<int, 2>& direction, int distance) {
    for (int i = 1; i <= distance; ++i) {
      const int to_x = x + direction[0] * i;
      const int to_z = z + direction[1] * i;
      if (to_x < 0 || to_x >= width_ || to_z < 0 || to_z >= depth_ || !open(to_x, y, to_z)) return false;
    }
    return true;
  }

  bool any_was_ground(int x, int first, int last, int z) {
    for (int y = first; y <= last; ++y) {
      if (was_ground(x, y, z)) return true;
    }
    return false;
  }

  void move(const Target& from, const Target& to) {
    // What is above comes after it: water, or air.
    const bool under_water = from.y + 1 < rows_ && at(from.x, from.y + 1, from.z).now == kWater;
    at(to.x, to.y, to.z).now = std::exchange(at(from.x, from.y, from.z).now, under_water ? kWater : kAir);
    columns_.set_around(from.x, from.z);
    columns_.set_around(to.x, to.z);
    ++moves_;
  }

  int width_;
  int rows_;
  int depth_;
  const SettleRules& rules_;
  std::span<SettlingVoxel> voxels_;
  Columns columns_;
  int moves_ = 0;
};

}  // namespace

std::optional<VoxelBox> settle_box(const Edit& edit) {
  constexpr auto kMost = std::numeric_limits<std::int64_t>::max();
  VoxelBox box{{kMost, kMost, kMost}, {-kMost, -kMost, -kMost}};
  const auto add = [&](VoxelPos first, VoxelPos last) {
    box.first = {std::min(box.first.x, first.x), std::min(box.first.y, first.y),
                 std::min(box.first.z, first.z)};
    box.last = {std::max(box.last.x, last.x), std::max(box.last.y, last.y), std::max(box.last.z, last.z)};
  };
  for (const VoxelWrite& each : edit.writes) add(each.voxel, each.voxel);
  for (const Fill& each : edit.fills) add(each.first, each.last);
  if (edit.paste) add(edit.paste->origin, last_of(*edit.paste));
  if (box.first.x > box.last.x) return std::nullopt;  // guards alone

  const std::int64_t width = box.last.x - box.first.x + 1;
  const std::int64_t depth = box.last.z - box.first.z + 1;
  const std::int64_t spare = kSettleRows - (box.last.y - box.first.y + 1);
  if (width > kSettleColumns || depth > kSettleColumns || spare < 0) return std::nullopt;
  std::int64_t margin = kSettleMargin;
  while (margin > 0 && (width + 2 * margin) * (depth + 2 * margin) > kSettleColumns) --margin;
  if (margin == 0) return std::nullopt;
  // What is above comes down; below is only what it may fall into.
  const std::int64_t below = spare / 3;
  box.first = {box.first.x - margin, box.first.y - below, box.first.z - margin};
  box.last = {box.last.x + margin, box.last.y + (spare - below), box.last.z + margin};
  if (!chunk_holding(box.first, Lod{}) || !chunk_holding(box.last, Lod{})) return std::nullopt;
  return box;
}

int settle(const VoxelBox& box, const SettleRules& rules, std::span<SettlingVoxel> voxels) {
  return Settling{box, rules, voxels}.run();
}

}  // namespace talus::edits
