// The land with the edits of a store, as export and map show it.
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <talus/files/npy_file.h>
#include <talus/terrain/extraction.h>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "export.h"
#include "land_edits.h"
#include "map.h"
#include "scratch_directory.h"
#include "talus_gen.h"
#include "tops_of_edits.h"
#include "worlds.h"

using namespace talus;
using namespace talus::tools;

namespace {

constexpr MaterialId kGlass{300};

/// Edits that a test makes.
class FakeEdits final : public LandEdits {
 public:
  void put(VoxelPos at, Lod lod, MaterialId material) {
    voxels_[*chunk_holding(at, lod)][static_cast<std::uint16_t>(voxel_index(local_pos(at)))] = material;
  }
  ContentHash store_id() const override { return {3, 4}; }
  std::uint64_t revision() const override { return 17; }
  const std::vector<terrain::Material>& materials() const override { return materials_; }
  ChunkRange edited_rows(ChunkKey key) const override {
    ChunkRange rows;
    for (const auto& [at, voxels] : voxels_) {
      if (at.lod != key.lod || at.coord.x != key.coord.x || at.coord.z != key.coord.z) continue;
      rows = rows.size() == 0 ? ChunkRange{at.coord.y, at.coord.y}
                              : ChunkRange{std::min<std::int64_t>(rows.first, at.coord.y),
                                           std::max<std::int64_t>(rows.last, at.coord.y)};
    }
    return rows;
  }
  Expected<edits::ChunkOverrides> overrides(ChunkKey key) const override {
    if (broken) return failed("the store is damaged");
    const auto found = voxels_.find(key);
    if (found == voxels_.end()) return edits::ChunkOverrides{};
    std::vector<Override> all;
    for (const auto& [index, material] : found->second) all.push_back({index, material});
    return edits::ChunkOverrides{std::move(all)};
  }
  bool broken = false;

 private:
  std::vector<terrain::Material> materials_{
      {kGlass, "glass", {10, 200, 250}, terrain::MaterialKind::stratified}};
  std::map<ChunkKey, std::map<std::uint16_t, MaterialId>> voxels_;
};

const terrain::World& world() {
  static const terrain::World kWorld = test::small_world(5);
  return kWorld;
}

/// The row over the highest voxel of a column that is not air.
std::int64_t top_of(std::int64_t x, std::int64_t z, Lod lod) {
  for (std::int64_t y = terrain::highest_row(world(), lod);; --y) {
    if (generate_chunk(world(), *chunk_holding({x, y, z}, lod)).at(local_pos({x, y, z})) != kAir)
      return y + 1;
  }
}

}  // namespace

TEST_CASE("an export with edits has them, from the lowest to the highest, and all else as generated") {
  for (const int level : {0, 2}) {
    const terrain::Region region{-40, -20, 70, 45, Lod::of(level)};
    FakeEdits edits;
    const std::int64_t top = top_of(-3, 5, region.lod);
    edits.put({-3, top - 1, 5}, region.lod, kAir);
    edits.put({-3, top + 70, 5}, region.lod, kGlass);  // a chunk of air between them
    edits.put({20, -50, 10}, region.lod, kAir);
    edits.put({29, 3, 24}, region.lod, kGlass);
    edits.put({30, 3, 24}, region.lod, kGlass);  // beyond the region
    const ScratchDirectory with;
    const ScratchDirectory without;
    ProgressBar progress{"export", "columns"};
    REQUIRE(export_region(world(), region, with.path(), {.patch_edge = 30, .edits = &edits}, progress));
    REQUIRE(export_region(world(), region, without.path(), {.patch_edge = 50}, progress));
    for (const char* const same : {"surface.npy", "eroded.npy", "shown.npy"}) {
      CHECK(read_whole(with / same) == read_whole(without / same));
    }
    const auto json = nlohmann::json::parse(read_whole(with / "export.json"));
    CHECK(json["store"] == nlohmann::json{{"id", to_string(ContentHash{3, 4})}, {"revision", 17}});
    CHECK(json["materials"].back() == nlohmann::json{{"id", 300}, {"name", "glass"}, {"kind", "placeable"}});
    CHECK(json["y0"] == -64);
    const std::string bytes = read_whole(with / "voxels.npy");
    std::vector<std::uint16_t> voxels((bytes.size() - files::kNpyHeaderBytes) / 2);
    std::memcpy(voxels.data(), bytes.data() + files::kNpyHeaderBytes, voxels.size() * 2);
    const auto rows = static_cast<std::int64_t>(voxels.size() / region.columns());
    CHECK(rows == top + 71 + 64);
    std::size_t wrong = 0;
    for (std::int64_t z = region.z; z < region.z + region.depth; ++z) {
      for (std::int64_t x = region.x; x < region.x + region.width; ++x) {
        for (std::int64_t y = -64; y < rows - 64; y += 32) {
          const ChunkKey key = *chunk_holding({x, y, z}, region.lod);
          static std::map<ChunkKey, Chunk> chunks;
          auto chunk = chunks.find(key);
          if (chunk == chunks.end()) {
            chunk =
                chunks.emplace(key, edits.overrides(key)->merged_over(generate_chunk(world(), key))).first;
          }
          for (std::int64_t row = y; row < std::min(y + 32, rows - 64); ++row) {
            const auto at = static_cast<std::size_t>(
                ((row + 64) * region.depth + (z - region.z)) * region.width + (x - region.x));
            wrong += voxels[at] != to_integer(chunk->second.at(local_pos({x, row, z})));
          }
        }
      }
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("a map with edits shows what is seen of them from above, and else what it showed") {
  const terrain::Region region{-40, -20, 90, 70, Lod{}};
  ProgressBar progress{"map", "columns"};
  const auto draw = [&](const FakeEdits& edits, int patch) {
    const TopsOfEdits tops{world(), edits};
    return render_map(world(), region, {.patch_edge = patch, .edits = &tops}, progress);
  };
  const Image plain = render_map(world(), region, {}, progress);
  FakeEdits none;
  none.put({0, top_of(0, 0, Lod{}) - 9, 0}, Lod{}, kAir);  // under the ground
  CHECK(draw(none, 256).rgb == plain.rgb);

  FakeEdits edits;
  for (std::int64_t z = 0; z < 8; ++z) {
    for (std::int64_t x = 0; x < 8; ++x) {
      edits.put({x, 200, z}, Lod{}, kGlass);
      edits.put({x, 190, z}, Lod{}, MaterialId{2});  // under it
    }
  }
  const Image roofed = draw(edits, 256);
  CHECK(draw(edits, 33).rgb == roofed.rgb);
  const terrain::Colour roof = roofed.at(44, 24);
  CHECK(roof.blue > roof.red + 80);  // as glass
  CHECK(roof.green > roof.red + 80);
  std::size_t changed = 0;
  std::size_t far = 0;  // beyond its shadow
  for (int z = 0; z < region.depth; ++z) {
    for (int x = 0; x < region.width; ++x) {
      if (roofed.at(x, z) == plain.at(x, z)) continue;
      ++changed;
      far += x < 40 - 25 || x > 48 + 25 || z < 20 - 25 || z > 28 + 25;
    }
  }
  CHECK(changed >= 64);
  CHECK(far == 0);

  edits.broken = true;
  const TopsOfEdits tops{world(), edits};
  CHECK(tops.find(region).empty());
  REQUIRE(tops.failure());
  CHECK(tops.failure()->message == "the store is damaged");
}

TEST_CASE("a material that neither the world nor the store names is refused where it would be seen") {
  const terrain::Region one{3, 3, 1, 1, Lod{}};
  for (const MaterialId unnamed : {MaterialId{299}, MaterialId{65'535}}) {
    FakeEdits edits;
    edits.put({3, top_of(3, 3, Lod{}) + 4, 3}, Lod{}, unnamed);
    const TopsOfEdits tops{world(), edits};
    CHECK(tops.find(one).empty());
    REQUIRE(tops.failure());
    CHECK_THAT(tops.failure()->message, Catch::Contains("has no name in the store"));
  }
}

TEST_CASE("water that was put or taken is seen from above") {
  const terrain::Region one{3, 3, 1, 1, Lod{}};
  FakeEdits edits;
  const std::int64_t top = top_of(3, 3, Lod{});
  edits.put({3, top + 4, 3}, Lod{}, kWater);
  const TopsOfEdits tops{world(), edits};
  const auto found = tops.find(one);
  REQUIRE(found.size() == 1);
  CHECK(found[0].row <= top);
  CHECK(found[0].water == kWater);
  CHECK(found[0].water_row == top + 5);
}

TEST_CASE("The store of --store must be of the world") {
  const ScratchDirectory scratch;
  const std::string store = " --store '" + scratch.path().string() + "'";
  const std::string out = " -o '" + (scratch / "a.png").string() + "'";
  const auto refused = [&](const std::string& arguments, const std::string& part) {
    const auto outcome = test::talus_gen(arguments);
    INFO(arguments << "\n" << outcome.errors);
    CHECK(outcome.exit_code != 0);
    CHECK(std::count(outcome.errors.begin(), outcome.errors.end(), '\n') == 1);
    CHECK_THAT(outcome.errors, Catch::Contains(part));
  };
#ifdef TALUS_HAS_STORE
  refused("map --center 0,0 --size 8,8" + store + out, "it has no store.toml");
  std::ofstream{scratch / "lock"};
  std::ofstream{scratch / "store.toml"} << "store_id = \"" << std::string(32, '1') << "\"\nfingerprint = \""
                                        << std::string(32, '2') << "\"\n";
  std::filesystem::permissions(scratch / "store.toml", std::filesystem::perms{0600});
  refused("export --origin 0,0 --size 8,8" + store + out, std::string(32, '2'));
#else
  refused("map --center 0,0 --size 8,8" + store + out, "built without talusd");
#endif
  refused("map --center 0,0 --size 8,8 --every 8" + store + out, "--store");
}
