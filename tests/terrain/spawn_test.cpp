#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <talus/terrain/extraction.h>
#include <talus/terrain/heights.h>

#include "worlds.h"

namespace talus::terrain {
namespace {

MaterialId voxel_at(const World& world, VoxelPos pos) {
  const auto key = chunk_holding(pos, Lod{});
  return generate_chunk(world, *key).at(local_pos(pos));
}

TEST_CASE("A spawn stands on solid ground in free air, and dry where any ground is") {
  CHECK(rc::check([] {
    const World world = test::small_world(*rc::gen::arbitrary<std::uint64_t>());
    const VoxelPos feet = find_spawn(world);
    RC_ASSERT(voxel_at(world, feet) == kAir);
    const MaterialId under = voxel_at(world, {feet.x, feet.y - 1, feet.z});
    RC_ASSERT(under != kAir);
    RC_ASSERT(under != kWater);
  }));
}

TEST_CASE("In a world full of bushes the spawn is near all the same") {
  const std::string bushes =
      "[[object]]\nname = \"bush\"\nmodel = \"bush\"\nspacing = 6\nchance = 1\n"
      "leaves = { name = \"leaves\", colour = \"#4a7d33\" }\n";
  const auto world = World::parse(test::small_world_text(7) + bushes, "bushes.toml");
  REQUIRE(world);
  const VoxelPos feet = find_spawn(*world);
  CHECK(std::max(std::abs(feet.x), std::abs(feet.z)) < 4096);
}

TEST_CASE("In a world all sea the spawn floats on the water") {
  std::string text = test::small_world_text(1);
  text.replace(text.find("sea_level = 0.3"), 15, "sea_level = 9.0");
  const auto world = World::parse(text, "sea.toml");
  REQUIRE(world);
  const VoxelPos feet = find_spawn(*world);
  CHECK(voxel_at(*world, feet) == kAir);
  CHECK(voxel_at(*world, {feet.x, feet.y - 1, feet.z}) == kWater);
}

}  // namespace
}  // namespace talus::terrain
