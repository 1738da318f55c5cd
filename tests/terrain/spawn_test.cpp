#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
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

TEST_CASE("If forests grow the spawn has trees in sight, not in its face, and level ground around") {
  const auto name = GENERATE(as<std::string>{}, "default", "alpine", "archipelago");
  CAPTURE(name);
  const World& world = test::sample_world(name);
  const VoxelPos feet = find_spawn(world);
  const Stacks around = generate_stacks(world, {feet.x - 96, feet.z - 96, 192, 192, Lod{}});
  const auto kinds = world.object_kinds();
  int trees = 0;
  int close = 0;
  for (const PlacedObject& object : around.objects) {
    const std::string& model = kinds.at(object.kind).model;
    if (model != "broadleaf" && model != "conifer" && model != "jungle_tree" && model != "acacia") continue;
    const std::int64_t away = std::max(std::abs(object.x - feet.x), std::abs(object.z - feet.z));
    if (away <= 96) ++trees;
    if (away <= 5) ++close;
  }
  CHECK(trees >= 10);
  CHECK(close == 0);
  const auto ground = [&](int x, int z) { return around.ground_fx(96 + x, 96 + z) / kSubvoxels; };
  for (const int away : {-16, 16}) {
    CHECK(std::abs(ground(away, 0) - ground(0, 0)) <= 8);
    CHECK(std::abs(ground(0, away) - ground(0, 0)) <= 8);
  }
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
