#include <talus/local/edits.h>

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <catch2/catch.hpp>

#include <talus/edits/runs.h>
#include <talus/local/settle_rules.h>
#include <talus/terrain/extraction.h>

namespace {

using namespace talus;

constexpr std::string_view kPlaceables =
    "\n[[placeable]]\nname = \"planks\"\ncolour = \"#8a6b3d\"\n[[placeable]]\nname = \"glass\"\ncolour = "
    "\"#ddeeff\"\n";

std::shared_ptr<const local::World> classic() {
  const std::string toml = std::string{terrain::classic_world_toml()} + std::string{kPlaceables};
  return *local::open_world(std::as_bytes(std::span{toml}));
}

/// The highest row of ground at a column.
std::int64_t ground(const local::World& world, std::int64_t x, std::int64_t z) {
  return (local::heights(world, {x, z, 1, 1, {}}).front() - 1) / terrain::kSubvoxels;
}

edits::Edit filled(VoxelPos first, VoxelPos last, MaterialId material) {
  return {{}, {}, {{first, last, material, {}}}, {}};
}

edits::Edit written(VoxelPos voxel, MaterialId material) {
  return {{}, {{voxel, material}}, {}, {}};
}

edits::StateHash hash_of(const local::Edits& edits) {
  edits::StateHash hash;
  for (const ChunkCoord chunk : edits.changed_chunks()) {
    hash.add(chunk, *edits::decode_runs(edits.overrides(chunk)));
  }
  return hash;
}

/// A chunk of any level with edits.
Chunk merged(const local::World& world, const local::Edits& edits, ChunkKey key) {
  return edits.merged_over(key, terrain::generate_chunk(world, key));
}

/// Of level 0 and of those above it at the origin.
void check_equal(const local::World& world, const local::Edits& a, const local::Edits& b) {
  CHECK(a.hash() == b.hash());
  REQUIRE(a.changed_chunks() == b.changed_chunks());
  for (const ChunkCoord chunk : a.changed_chunks()) {
    CHECK(a.overrides(chunk) == b.overrides(chunk));
    for (int level = 0; level <= Lod::kMax; ++level) {
      const ChunkKey key{{chunk.x >> level, chunk.y >> level, chunk.z >> level}, Lod::of(level)};
      INFO(to_string(key));
      CHECK(merged(world, a, key) == merged(world, b, key));
    }
  }
}

constexpr std::array kNothing{std::byte{0}, std::byte{0}};  // the empty set of runs

}  // namespace

TEST_CASE("restored edits are the same at every level") {
  const auto world = classic();
  local::Workspace workspace{world};
  local::Edits edits;
  REQUIRE(edits.apply(workspace, filled({-8, 0, -8}, {8, 200, 8}, local::placeable_id(0))));
  REQUIRE(edits.apply(workspace, filled({-2, 0, -2}, {8, 100, 2}, kAir)));
  CHECK(edits.hash() == hash_of(edits));
  REQUIRE(edits.changed_chunks().size() > 8);

  local::Edits restored;
  std::size_t coarse = 0;
  for (const ChunkCoord chunk : edits.changed_chunks()) {
    const auto changed = restored.restore(*world, chunk, edits.overrides(chunk));
    REQUIRE(changed);
    CHECK(changed->front() == ChunkKey{chunk, {}});
    coarse += changed->size() - 1;
    // Nothing is left to change.
    CHECK(restored.restore(*world, chunk, edits.overrides(chunk))->empty());
  }
  CHECK(coarse > 0);
  check_equal(*world, edits, restored);

  // Another state of the same chunks, then as generated.
  REQUIRE(edits.apply(workspace, filled({-1, 0, -1}, {1, 180, 1}, kAir)));
  for (const ChunkCoord chunk : edits.changed_chunks()) {
    REQUIRE(restored.restore(*world, chunk, edits.overrides(chunk)));
  }
  check_equal(*world, edits, restored);
  for (const ChunkCoord chunk : edits.changed_chunks()) REQUIRE(restored.restore(*world, chunk, kNothing));
  CHECK(restored.changed_chunks().empty());
  CHECK(restored.hash() == edits::StateHash{});
  check_equal(*world, local::Edits{}, restored);
}

TEST_CASE("bytes that no edit could have left are refused whole") {
  const auto world = classic();
  local::Workspace workspace{world};
  local::Edits edits;
  REQUIRE(edits.apply(workspace, written({1, 2, 3}, local::placeable_id(0))));
  const std::vector<std::byte> good = edits.overrides({0, 0, 0});
  const auto refused = [&](ChunkCoord chunk, std::span<const std::byte> bytes) {
    const auto done = edits.restore(*world, chunk, bytes);
    REQUIRE_FALSE(done);
    CHECK(edits.overrides({0, 0, 0}) == good);
    CHECK(edits.changed_chunks().size() == 1);
    return done.error().message;
  };
  CHECK_THAT(refused({0, 0, 0}, {good.data(), good.size() - 1}), Catch::Contains("chunk (0, 0, 0)"));
  const auto runs = [](MaterialId material) {
    std::vector<std::byte> bytes;
    edits::encode_runs(std::vector<Override>{{0, kAir}, {5, material}}, bytes);
    return bytes;
  };
  CHECK_THAT(refused({0, 0, 0}, runs(MaterialId{999})), Catch::Contains("material 999"));
  CHECK_THAT(refused({0, 100'000, 0}, runs(local::placeable_id(0))), Catch::Contains("row 3200000"));
  CHECK_THAT(refused({0, -100'000, 0}, runs(local::placeable_id(0))), Catch::Contains("row -3200000"));
}

TEST_CASE("placeables keep the ids that a save gave to their names") {
  const auto world = classic();
  CHECK(local::placeable_ids(*world, {}) == std::vector{local::placeable_id(0), local::placeable_id(1)});
  const edits::MaterialIds known{
      {"glass", MaterialId{256}}, {"lost", MaterialId{300}}, {"sand", MaterialId{3}}};
  const auto ids = local::placeable_ids(*world, known);
  REQUIRE(ids == std::vector{MaterialId{301}, MaterialId{256}});
  local::Workspace workspace{world};
  local::Edits edits{{false, *ids}};
  CHECK(edits.apply(workspace, written({0, 0, 0}, MaterialId{301})));
  CHECK_FALSE(edits.apply(workspace, written({0, 0, 0}, MaterialId{257})));
  CHECK_FALSE(local::placeable_ids(*world, {{"last", MaterialId{65'535}}}));
}

TEST_CASE("loose material settles if it is told to") {
  const auto world = *local::open_world(std::as_bytes(std::span{terrain::default_world_toml()}));
  const edits::SettleRules rules = local::settle_rules(*world);
  REQUIRE_FALSE(rules.empty());
  local::Workspace workspace{world};
  local::Edits loose{{true, {}}};
  local::Edits still;
  // A pillar of loose material falls apart.
  const std::int64_t y = ground(*world, -2700, -2300) + 1;
  const edits::Edit pillar = filled({-2700, y, -2300}, {-2700, y + 9, -2300}, rules.front().material);
  const auto settled = loose.apply(workspace, pillar);
  REQUIRE(settled);
  CHECK(settled->changed == 10);  // none is lost
  CHECK(still.apply(workspace, pillar)->changed == 10);
  const auto voxel = [&](const local::Edits& edits) {
    const VoxelPos top{-2700, y + 9, -2300};
    return merged(*world, edits, *chunk_holding(top, {})).at(local_pos(top));
  };
  CHECK(voxel(loose) == kAir);
  CHECK(voxel(still) == rules.front().material);
  CHECK(loose.hash() == hash_of(loose));
}
