#include "export.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include <talus/files/npy_file.h>
#include <talus/terrain/extraction.h>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "scratch_directory.h"

using namespace talus;
using namespace talus::tools;
using talus::files::kNpyHeaderBytes;

namespace {

const terrain::Region kRegion{-45, -7, 70, 50, Lod{}};
constexpr std::size_t kColumns = 70 * 50;

Expected<void> export_to(const std::filesystem::path& directory, const ExportOptions& options = {}) {
  ProgressBar progress{"export", "columns"};
  return export_region(terrain::default_world(), kRegion, directory, options, progress);
}

template <typename Item>
std::vector<Item> items_of(const std::filesystem::path& path) {
  const std::string bytes = read_whole(path);
  REQUIRE(bytes.size() >= kNpyHeaderBytes);
  std::vector<Item> items((bytes.size() - kNpyHeaderBytes) / sizeof(Item));
  std::memcpy(items.data(), bytes.data() + kNpyHeaderBytes, items.size() * sizeof(Item));
  return items;
}

std::string shape_of(const std::filesystem::path& path) {
  const std::string bytes = read_whole(path);
  const std::size_t open = bytes.find('(');
  return bytes.substr(open, bytes.find(')') - open + 1);
}

std::string shape(std::size_t slices) {
  return "(" + std::to_string(slices) + ", 50, 70)";
}

// One export serves all the cases that only read.
const ScratchDirectory& exported() {
  static const ScratchDirectory scratch;
  static const bool done = export_to(scratch.path()).has_value();
  REQUIRE(done);
  return scratch;
}

nlohmann::json exported_json() {
  return nlohmann::json::parse(read_whole(exported() / "export.json"));
}

}  // namespace

TEST_CASE("An export has exactly the files and shapes that it promises") {
  const auto json = exported_json();
  CHECK(exported().file_count() == 6);
  CHECK(shape_of(exported() / "surface.npy") == "(50, 70)");
  CHECK(shape_of(exported() / "slope.npy") == "(50, 70)");
  CHECK(shape_of(exported() / "eroded.npy") == shape(json["eroded"].size()));
  CHECK(shape_of(exported() / "strata.npy") == shape(json["layers"].size()));
  CHECK(shape_of(exported() / "voxels.npy") ==
        shape(items_of<std::uint8_t>(exported() / "voxels.npy").size() / kColumns));
}

TEST_CASE("export.json says what the arrays mean") {
  const auto json = exported_json();
  const terrain::World& world = terrain::default_world();
  CHECK(json["fingerprint"] == to_string(world.fingerprint()));
  CHECK(json["fingerprint"].get<std::string>().size() == 32);
  CHECK(json["resolution"] == world.spec().resolution);
  CHECK(json["origin"] == nlohmann::json({-45, -7}));
  CHECK(json["size"] == nlohmann::json({70, 50}));
  CHECK(json["y0"] == 0);
  CHECK(json["halo"] == world.halo());
  REQUIRE(json["materials"].size() == world.materials().size());
  CHECK(json["materials"][0] == nlohmann::json({{"id", 0}, {"name", "air"}, {"kind", "air"}}));
  CHECK(json["materials"][1] == nlohmann::json({{"id", 1}, {"name", "water"}, {"kind", "water"}}));
  REQUIRE(json["eroded"].size() == world.loose().size());
  for (std::size_t i = 0; i < world.loose().size(); ++i) {
    const terrain::LooseSpec& loose = world.loose()[i];
    const std::uint16_t id = to_integer(loose.material);
    CHECK(json["eroded"][i] == nlohmann::json({{"id", id},
                                               {"name", world.materials()[id].name},
                                               {"weight", loose.weight},
                                               {"t_fx", loose.t_fx},
                                               {"S_fx", loose.S_fx},
                                               {"c_fx", loose.c_fx}}));
  }
  CHECK(json.size() == 9);
}

TEST_CASE("The planes of an export rise to the surface") {
  const auto surface = items_of<std::int32_t>(exported() / "surface.npy");
  const auto strata = items_of<std::int32_t>(exported() / "strata.npy");
  REQUIRE(strata.size() >= kColumns);
  CHECK(std::equal(surface.begin(), surface.end(), strata.end() - kColumns));
  for (std::size_t i = kColumns; i < strata.size(); ++i) REQUIRE(strata[i] >= strata[i - kColumns]);
}

TEST_CASE("Exported loose material is within its thickness and at rest") {
  const auto eroded = items_of<std::int32_t>(exported() / "eroded.npy");
  const auto& loose = terrain::default_world().loose();
  for (std::size_t m = 0; m < loose.size(); ++m) {
    for (std::size_t i = 0; i < kColumns; ++i) {
      const std::int32_t here = eroded[m * kColumns + i];
      REQUIRE(here >= 0);
      REQUIRE(here <= loose[m].t_fx);
      if (i % 70 != 0) REQUIRE(std::abs(here - eroded[m * kColumns + i - 1]) <= loose[m].c_fx);
      if (i >= 70) REQUIRE(std::abs(here - eroded[m * kColumns + i - 70]) <= loose[m].c_fx);
    }
  }
}

TEST_CASE("Exported voxels are the chunks' voxels, and everything above them is air") {
  const auto voxels = items_of<std::uint8_t>(exported() / "voxels.npy");
  const auto rows = static_cast<std::int64_t>(voxels.size() / kColumns);
  for (std::int64_t z = kRegion.z; z < kRegion.z + kRegion.depth; z += 7) {
    for (std::int64_t x = kRegion.x; x < kRegion.x + kRegion.width; x += 9) {
      for (std::int64_t chunk_y = 0; chunk_y <= rows / kChunkSize; ++chunk_y) {
        const VoxelPos lowest{x, chunk_y * kChunkSize, z};
        const Chunk chunk = generate_chunk(terrain::default_world(), *chunk_holding(lowest, Lod{}));
        for (std::int64_t y = lowest.y; y < lowest.y + kChunkSize; ++y) {
          const std::uint16_t expected = to_integer(chunk.at(local_pos({x, y, z})));
          const auto index = static_cast<std::size_t>((y * 50 + (z - kRegion.z)) * 70 + (x - kRegion.x));
          REQUIRE(expected == (y < rows ? voxels[index] : 0));
        }
      }
    }
  }
}

TEST_CASE("The highest exported row of voxels is not empty") {
  const auto voxels = items_of<std::uint8_t>(exported() / "voxels.npy");
  CHECK(std::any_of(voxels.end() - kColumns, voxels.end(), [](std::uint8_t id) { return id != 0; }));
}

TEST_CASE("An export does not depend on threads or patches, and replaces an older one") {
  const ScratchDirectory scratch;
  REQUIRE(export_to(scratch.path(), {.threads = 3, .patch_edge = 128}));
  REQUIRE(export_to(scratch.path(), {.threads = 2, .patch_edge = 13}));
  CHECK(scratch.file_count() == 6);
  for (const char* name :
       {"surface.npy", "slope.npy", "eroded.npy", "strata.npy", "voxels.npy", "export.json"}) {
    CHECK(read_whole(scratch / name) == read_whole(exported() / name));
  }
}

TEST_CASE("An export past the limit is refused before it makes anything") {
  const ScratchDirectory scratch;
  const auto outcome = export_to(scratch / "out", {.max_bytes = 1000});
  REQUIRE_FALSE(outcome);
  CHECK(outcome.error().exit_code == kExitWrongUse);
  CHECK_THAT(outcome.error().message, Catch::StartsWith("--size: 70 x 50 columns could take "));
  CHECK(scratch.file_count() == 0);
}
