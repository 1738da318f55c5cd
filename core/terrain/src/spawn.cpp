#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <talus/terrain/boundary_row.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/heights.h>
#include <talus/terrain/slope.h>
#include <talus/terrain/surface.h>

namespace talus::terrain {
namespace {

constexpr int kReach = 32;                              // candidates on each side of the origin, per step
constexpr std::array<int, 4> kSteps{4, 32, 256, 2048};  // columns between candidates
constexpr std::int32_t kGentle_fx = 90;                 // rise per column, about 19 degrees
constexpr std::int32_t kSteep_fx = 256 * 64;            // any slope

// The search for a view uses a coarse grid: its reach is a walk, and kSeen is the range of sight.
constexpr std::int64_t kViewStep = 64;
constexpr int kViewReach = 48;
constexpr int kSeen = 8;
constexpr int kShore = 4;
constexpr std::int32_t kHighestView_fx = 220 * kSubvoxels;
constexpr std::int32_t kShoreWorth_fx = 60 * kSubvoxels;
constexpr std::int32_t kStepWorth_fx = 2 * kSubvoxels;
// A nearby slope hides the land behind it.
constexpr std::int32_t kLevel_fx = 10 * kSubvoxels;  // rise or fall to the next grid point
constexpr std::int32_t kSlopeWorth = -5;             // per further block
// Of the best views the greenest is chosen: with trees in sight, but none close enough to block the view.
// Adjacent views see the same trees.
constexpr std::size_t kViewsLookedAt = 32;
constexpr std::int64_t kViewsApart = 3 * kViewStep;
constexpr std::int64_t kPaces = 16;  // columns
constexpr Lod kTreesLod = Lod::of(2);
constexpr std::int64_t kTreesReach = 96;  // columns
constexpr std::int64_t kTooClose = 20;
constexpr int kEnoughTrees = 24;
constexpr std::int32_t kTreeWorth_fx = 6 * kSubvoxels;
constexpr std::int32_t kCloseTreeWorth_fx = -24 * kSubvoxels;
constexpr std::array<std::string_view, 4> kTreeModels{"broadleaf", "conifer", "jungle_tree", "acacia"};

constexpr std::int64_t kFreeOfObjects = 5;  // columns to the foot of the nearest object
constexpr int kMaxOvergrown = 64;           // places tried before an overgrown one is accepted

struct Candidate {
  std::int64_t x;
  std::int64_t z;
  std::int32_t height_fx;
};

class SpawnSearch {
 public:
  explicit SpawnSearch(const World& world)
      : world_{world},
        surface_{surface_of(world.spec())},
        sea_fx_{world.sea_fx().value_or(-1)},
        dry_fx_{sea_fx_ < 0 ? 0 : sea_fx_ + 2 * kSubvoxels} {
    surface_.places.reset();
    for (const LooseSpec& loose : world.loose()) loose_fx_ += loose.t_fx;
    for (const ObjectKindName& kind : world.object_kinds()) {
      is_tree_.push_back(std::find(kTreeModels.begin(), kTreeModels.end(), kind.model) != kTreeModels.end());
    }
  }

  [[nodiscard]] VoxelPos find() const {
    if (world_.spec().surface.regions) {
      if (const auto place = with_a_view()) return *place;
    }
    for (const std::int32_t steepest_fx : {kGentle_fx, kSteep_fx}) {
      for (const int step : kSteps) {
        if (const auto place = nearest(step, steepest_fx)) return *place;
      }
    }
    const BaseColumn origin{0, 0};
    return standing(0, 0, surface_heights(world_, {&origin, 1}).front());
  }

 private:
  struct Grid {
    std::vector<std::int64_t> line;
    std::vector<std::int32_t> heights;
    [[nodiscard]] std::int32_t at(int x, int z) const {
      return heights[static_cast<std::size_t>(z) * line.size() + static_cast<std::size_t>(x)];
    }
  };

  [[nodiscard]] Grid grid(int reach, std::int64_t step) const {
    Grid grid;
    for (int i = -reach; i <= reach; ++i) grid.line.push_back(i * step);
    grid.heights.resize(grid.line.size() * grid.line.size());
    sample_surface(surface_, grid.line, grid.line, grid.heights);
    return grid;
  }

  [[nodiscard]] std::optional<VoxelPos> nearest(int step, std::int32_t steepest_fx) const {
    const Grid around = grid(kReach, step);
    std::vector<Candidate> dry;
    for (int z = 0; z <= 2 * kReach; ++z) {
      for (int x = 0; x <= 2 * kReach; ++x) {
        const std::int32_t height_fx = around.at(x, z);
        if (height_fx < dry_fx_) continue;
        dry.push_back(
            {around.line[static_cast<std::size_t>(x)], around.line[static_cast<std::size_t>(z)], height_fx});
      }
    }
    std::stable_sort(dry.begin(), dry.end(), [](const Candidate& a, const Candidate& b) {
      return a.x * a.x + a.z * a.z < b.x * b.x + b.z * b.z;
    });
    return first_good(dry, steepest_fx);
  }

  struct View {
    Candidate place;
    std::int32_t worth_fx;
  };
  static void best_first(std::vector<View>& views) {
    std::stable_sort(views.begin(), views.end(),
                     [](const View& a, const View& b) { return a.worth_fx > b.worth_fx; });
  }

  /// Finds gentle ground below summits, next to water and among trees, not too far away.
  [[nodiscard]] std::optional<VoxelPos> with_a_view() const {
    const Grid around = grid(kViewReach + kSeen, kViewStep);
    std::vector<View> views;
    for (int z = kSeen; z <= kSeen + 2 * kViewReach; ++z) {
      for (int x = kSeen; x <= kSeen + 2 * kViewReach; ++x) {
        const std::int32_t height_fx = around.at(x, z);
        if (height_fx < dry_fx_) continue;
        std::int32_t highest_fx = 0;
        std::int32_t rise_fx = 0;
        bool shore = false;
        for (int j = -kSeen; j <= kSeen; ++j) {
          for (int i = -kSeen; i <= kSeen; ++i) {
            const std::int32_t seen_fx = around.at(x + i, z + j);
            highest_fx = std::max(highest_fx, seen_fx);
            if (std::max(std::abs(i), std::abs(j)) == 1) {
              rise_fx = std::max(rise_fx, std::abs(seen_fx - height_fx));
            }
            shore = shore || (std::max(std::abs(i), std::abs(j)) <= kShore && seen_fx < sea_fx_);
          }
        }
        const int away = std::max(std::abs(x - kSeen - kViewReach), std::abs(z - kSeen - kViewReach));
        const std::int32_t worth_fx = std::min(highest_fx - height_fx, kHighestView_fx) +
                                      (shore ? kShoreWorth_fx : 0) - away * kStepWorth_fx +
                                      std::max(rise_fx - kLevel_fx, 0) * kSlopeWorth;
        views.push_back(
            {{around.line[static_cast<std::size_t>(x)], around.line[static_cast<std::size_t>(z)], height_fx},
             worth_fx});
      }
    }
    best_first(views);
    std::vector<View> green = some_apart(views);
    for (View& view : green) view.worth_fx += worth_of_trees(view.place);
    best_first(green);
    std::vector<Candidate> best;
    for (const View& view : green) add_around(best, view.place);
    for (const View& view : views) best.push_back(view.place);
    return first_good(best, kGentle_fx);
  }

  /// Adds the place and its neighbours a few paces away, which may be gentle and free if the place is not.
  void add_around(std::vector<Candidate>& places, const Candidate& middle) const {
    places.push_back(middle);
    const std::array xs{middle.x - kPaces, middle.x, middle.x + kPaces};
    const std::array zs{middle.z - kPaces, middle.z, middle.z + kPaces};
    std::array<std::int32_t, 9> heights{};
    sample_surface(surface_, xs, zs, heights);
    for (std::size_t i = 0; i < heights.size(); ++i) {
      const bool is_middle = i == heights.size() / 2;
      if (!is_middle && heights[i] >= dry_fx_) places.push_back({xs[i % 3], zs[i / 3], heights[i]});
    }
  }

  /// Selects the best views that are not near a better one.
  [[nodiscard]] static std::vector<View> some_apart(std::span<const View> views) {
    std::vector<View> taken;
    for (const View& view : views) {
      if (taken.size() == kViewsLookedAt) break;
      const bool near = std::any_of(taken.begin(), taken.end(), [&](const View& other) {
        return std::max(std::abs(view.place.x - other.place.x), std::abs(view.place.z - other.place.z)) <
               kViewsApart;
      });
      if (!near) taken.push_back(view);
    }
    return taken;
  }

  [[nodiscard]] std::int32_t worth_of_trees(const Candidate& place) const {
    if (!world_.has_objects()) return 0;
    const int side = static_cast<int>(2 * kTreesReach >> kTreesLod.value());
    const auto first = [](std::int64_t middle) { return (middle - kTreesReach) >> kTreesLod.value(); };
    const Stacks around = generate_stacks(world_, {first(place.x), first(place.z), side, side, kTreesLod});
    int trees = 0;
    int close = 0;
    for (const PlacedObject& object : around.objects) {
      if (!is_tree_[object.kind]) continue;
      const std::int64_t away = std::max(std::abs(object.x - place.x), std::abs(object.z - place.z));
      trees += away <= kTreesReach ? 1 : 0;
      close += away <= kTooClose ? 1 : 0;
    }
    return std::min(trees, kEnoughTrees) * kTreeWorth_fx + close * kCloseTreeWorth_fx;
  }

  /// If objects stand at all tried places, returns the first good one anyway.
  [[nodiscard]] std::optional<VoxelPos> first_good(std::span<const Candidate> candidates,
                                                   std::int32_t steepest_fx) const {
    std::optional<VoxelPos> overgrown_place;
    int tried = 0;
    for (const Candidate& place : candidates) {
      if (slope_at(place.x, place.z) > steepest_fx) continue;
      // Erosion may have lowered the ground by no more than its loose material; a cave's entrance is deeper.
      const BaseColumn column{place.x, place.z};
      const std::int32_t ground_fx = surface_heights(world_, {&column, 1}).front();
      if (ground_fx < place.height_fx - loose_fx_) continue;
      const VoxelPos found = standing(place.x, place.z, ground_fx);
      if (!overgrown(place.x, place.z)) return found;
      if (!overgrown_place) overgrown_place = found;
      if (++tried == kMaxOvergrown) break;
    }
    return overgrown_place;
  }

  /// Returns true if an object is so near that a player would stand inside it.
  [[nodiscard]] bool overgrown(std::int64_t x, std::int64_t z) const {
    if (!world_.has_objects()) return false;
    const Stacks around = generate_stacks(world_, {x, z, 1, 1, Lod{}});
    return std::any_of(around.objects.begin(), around.objects.end(), [&](const PlacedObject& object) {
      return std::max(std::abs(object.x - x), std::abs(object.z - z)) <= kFreeOfObjects;
    });
  }

  [[nodiscard]] std::int32_t slope_at(std::int64_t x, std::int64_t z) const {
    Field around{3, 3};
    sample_surface(surface_, std::array{x - 1, x, x + 1}, std::array{z - 1, z, z + 1}, around.values);
    return slope_inside(around).at(0, 0);
  }

  [[nodiscard]] VoxelPos standing(std::int64_t x, std::int64_t z, std::int32_t ground_fx) const {
    return {x, boundary_row(std::max(ground_fx, sea_fx_)), z};
  }

  const World& world_;
  Surface surface_;
  std::int32_t sea_fx_;
  std::int32_t dry_fx_;  // keeps feet dry next to the shore
  std::int32_t loose_fx_ = 0;
  std::vector<bool> is_tree_;  // by PlacedObject::kind
};

}  // namespace

VoxelPos find_spawn(const World& world) {
  return SpawnSearch{world}.find();
}

}  // namespace talus::terrain
