#include <talus/local/local.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <catch2/catch.hpp>

#include <talus/terrain/extraction.h>
#include <talus/terrain/heights.h>

namespace {

using namespace talus;

auto open(std::string_view toml, const local::FileReader& files = {}) {
  return local::open_world(std::as_bytes(std::span{toml}), files);
}

struct Kept final : local::ChunkSink {
  void take(ChunkKey key, const Chunk& chunk) override {
    chunks.emplace(key, chunk);
    order.push_back(key);
    if (cancel_after == order.size()) cancel = true;
  }
  std::map<ChunkKey, Chunk> chunks;
  std::vector<ChunkKey> order;
  std::size_t cancel_after = 0;
  std::atomic<bool> cancel = false;
};

// Of two patches that alternate, and of two levels.
std::vector<ChunkKey> some_keys() {
  return {{{3, 2, 0}, {}},           {{4, 2, 0}, {}},    {{3, 3, 1}, {}},
          {{-1, 0, -1}, Lod::of(2)}, {{4, 4000, 0}, {}}, {{4, 1, 0}, {}}};
}

}  // namespace

TEST_CASE("chunks of a batch are those that are generated one by one") {
  const auto world = open(terrain::default_world_toml());
  REQUIRE(world);
  local::Workspace workspace{*world};
  Kept kept;
  REQUIRE(local::generate(workspace, some_keys(), kept, &kept.cancel) == some_keys().size());
  for (const ChunkKey key : some_keys()) {
    INFO(to_string(key));
    CHECK(kept.chunks.at(key) == terrain::generate_chunk(**world, key));
  }
  // A patch is made once: what shares it comes together.
  CHECK(kept.order[0] == some_keys()[0]);
  CHECK(kept.order[1] == some_keys()[2]);
  const terrain::MixedRange rows = workspace.rows(some_keys()[0]);
  CHECK(rows.first <= rows.last);
}

TEST_CASE("generation stops when it is told to") {
  const auto world = open(terrain::classic_world_toml());
  REQUIRE(world);
  local::Workspace workspace{*world};
  Kept kept;
  kept.cancel_after = 2;
  CHECK(local::generate(workspace, some_keys(), kept, &kept.cancel) == 2);
  CHECK(kept.order.size() == 2);
  CHECK_FALSE(workspace.prepare(ChunkKey{{100, 0, 100}, {}}, &kept.cancel));
}

TEST_CASE("heights are those of single columns") {
  const auto world = open(terrain::classic_world_toml());
  REQUIRE(world);
  const std::vector<std::int32_t> heights = local::heights(**world, {-5, 7, 3, 2, {}});
  std::vector<terrain::BaseColumn> columns;
  for (std::int64_t z = 7; z < 9; ++z) {
    for (std::int64_t x = -5; x < -2; ++x) columns.push_back({x, z});
  }
  CHECK(heights == terrain::surface_heights(**world, columns));
}

TEST_CASE("a problem has its place in parts") {
  const std::string toml = "resolution = 1\nseed   = \"seven\"\n";
  const auto world = open(toml);
  REQUIRE_FALSE(world);
  const local::SpecProblem& problem = world.error();
  CHECK(problem.line == 2);
  CHECK(problem.column == 10);
  CHECK(problem.key == "seed");
  CHECK(problem.text == "'seven' is a string; an integer is needed");
  CHECK(problem.message == "world.toml:2: seed: " + problem.text);

  const auto torn = open("seed = 1\nresolution = = 2\n");
  REQUIRE_FALSE(torn);
  CHECK(torn.error().line == 2);
  CHECK(torn.error().column > 1);
  CHECK(torn.error().key == "resolution");
}

TEST_CASE("files of a world come from its reader") {
  std::ifstream file{TALUS_SOURCE_DIR "/tests/golden/worlds/height_map.toml"};
  const std::string toml{std::istreambuf_iterator<char>{file}, {}};
  std::string asked;
  const auto none =
      open(toml, [&](const std::string& name) -> tl::expected<std::vector<std::byte>, std::string> {
        asked = name;
        return tl::unexpected<std::string>{"was not given"};
      });
  REQUIRE_FALSE(none);
  INFO(none.error().message);
  CHECK(asked == "made by the test");
  CHECK_THAT(none.error().text, Catch::Contains("was not given"));
}
