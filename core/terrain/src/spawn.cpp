#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <span>
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
constexpr std::int32_t kGentle_fx = 90;                 // rise a column, about 19 degrees
constexpr std::int32_t kSteep_fx = 256 * 64;            // any slope

// A view is looked for on a coarse grid: so far as one walks, and so far as one sees from there.
constexpr std::int64_t kViewStep = 64;
constexpr int kViewReach = 48;
constexpr int kSeen = 8;
constexpr int kShore = 4;
constexpr std::int32_t kHighestView_fx = 220 * kSubvoxels;
constexpr std::int32_t kShoreWorth_fx = 60 * kSubvoxels;
constexpr std::int32_t kStepWorth_fx = 2 * kSubvoxels;
constexpr std::int64_t kFreeOfObjects = 5;  // columns to the next one's foot
constexpr int kMaxOvergrown = 64;           // places that are looked at before one is taken all the same

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

  /// Gentle ground below summits and beside water, not too far away.
  [[nodiscard]] std::optional<VoxelPos> with_a_view() const {
    const Grid around = grid(kViewReach + kSeen, kViewStep);
    struct View {
      Candidate place;
      std::int32_t worth_fx;
    };
    std::vector<View> views;
    for (int z = kSeen; z <= kSeen + 2 * kViewReach; ++z) {
      for (int x = kSeen; x <= kSeen + 2 * kViewReach; ++x) {
        const std::int32_t height_fx = around.at(x, z);
        if (height_fx < dry_fx_) continue;
        std::int32_t highest_fx = 0;
        bool shore = false;
        for (int j = -kSeen; j <= kSeen; ++j) {
          for (int i = -kSeen; i <= kSeen; ++i) {
            const std::int32_t seen_fx = around.at(x + i, z + j);
            highest_fx = std::max(highest_fx, seen_fx);
            shore = shore || (std::max(std::abs(i), std::abs(j)) <= kShore && seen_fx < sea_fx_);
          }
        }
        const int away = std::max(std::abs(x - kSeen - kViewReach), std::abs(z - kSeen - kViewReach));
        const std::int32_t worth_fx = std::min(highest_fx - height_fx, kHighestView_fx) +
                                      (shore ? kShoreWorth_fx : 0) - away * kStepWorth_fx;
        views.push_back(
            {{around.line[static_cast<std::size_t>(x)], around.line[static_cast<std::size_t>(z)], height_fx},
             worth_fx});
      }
    }
    std::stable_sort(views.begin(), views.end(),
                     [](const View& a, const View& b) { return a.worth_fx > b.worth_fx; });
    std::vector<Candidate> best;
    for (const View& view : views) best.push_back(view.place);
    return first_good(best, kGentle_fx);
  }

  /// In a world full of objects the first good place, though one stands there.
  [[nodiscard]] std::optional<VoxelPos> first_good(std::span<const Candidate> candidates,
                                                   std::int32_t steepest_fx) const {
    std::optional<VoxelPos> overgrown_place;
    int tried = 0;
    for (const Candidate& place : candidates) {
      if (slope_at(place.x, place.z) > steepest_fx) continue;
      // Erosion may have changed the ground since, by no more than what was loose; a cave's entrance lies
      // deeper.
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

  /// Whether an object stands so near that one would stand in it.
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
  std::int32_t dry_fx_;  // feet stay dry beside the shore
  std::int32_t loose_fx_ = 0;
};

}  // namespace

VoxelPos find_spawn(const World& world) {
  return SpawnSearch{world}.find();
}

}  // namespace talus::terrain
