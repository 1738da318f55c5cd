#include <algorithm>
#include <array>
#include <vector>

#include <talus/terrain/boundary_row.h>
#include <talus/terrain/heights.h>
#include <talus/terrain/slope.h>
#include <talus/terrain/surface.h>

namespace talus::terrain {
namespace {

constexpr int kReach = 32;                              // candidates on each side of the origin, per step
constexpr std::array<int, 4> kSteps{4, 32, 256, 2048};  // columns between candidates
constexpr std::int32_t kGentle_fx = 90;                 // rise a column, about 19 degrees
constexpr std::int32_t kSteep_fx = 256 * 64;            // any slope

std::int32_t slope_at(const Surface& surface, std::int64_t x, std::int64_t z) {
  Field around{3, 3};
  sample_surface(surface, std::array{x - 1, x, x + 1}, std::array{z - 1, z, z + 1}, around.values);
  return slope_inside(around).at(0, 0);
}

}  // namespace

VoxelPos find_spawn(const World& world) {
  const Surface surface = surface_of(world.spec());
  const std::int32_t sea_fx = world.sea_fx().value_or(-1);
  const std::int32_t dry_fx = sea_fx < 0 ? 0 : sea_fx + 2 * kSubvoxels;  // feet stay dry beside the shore
  std::int32_t loose_fx = 0;
  for (const LooseSpec& loose : world.loose()) loose_fx += loose.t_fx;
  struct Candidate {
    std::int64_t x;
    std::int64_t z;
    std::int32_t height_fx;
  };
  for (const std::int32_t steepest_fx : {kGentle_fx, kSteep_fx}) {
    for (const int step : kSteps) {
      std::vector<std::int64_t> line;
      for (int i = -kReach; i <= kReach; ++i) line.push_back(std::int64_t{i} * step);
      std::vector<std::int32_t> heights(line.size() * line.size());
      sample_surface(surface, line, line, heights);
      std::vector<Candidate> dry;
      for (std::size_t i = 0; i < heights.size(); ++i) {
        if (heights[i] >= dry_fx) dry.push_back({line[i % line.size()], line[i / line.size()], heights[i]});
      }
      std::stable_sort(dry.begin(), dry.end(), [](const Candidate& a, const Candidate& b) {
        return a.x * a.x + a.z * a.z < b.x * b.x + b.z * b.z;
      });
      for (const Candidate& place : dry) {
        if (slope_at(surface, place.x, place.z) <= steepest_fx) {
          // Erosion may have changed the ground since, by no more than what was loose; a cave's entrance lies
          // deeper.
          const BaseColumn column{place.x, place.z};
          const std::int32_t ground_fx = surface_heights(world, {&column, 1}).front();
          if (ground_fx < place.height_fx - loose_fx) continue;
          return {place.x, boundary_row(std::max(ground_fx, sea_fx)), place.z};
        }
      }
    }
  }
  const BaseColumn origin{0, 0};
  const std::int32_t ground_fx = surface_heights(world, {&origin, 1}).front();
  return {0, boundary_row(std::max(ground_fx, sea_fx)), 0};
}

}  // namespace talus::terrain
