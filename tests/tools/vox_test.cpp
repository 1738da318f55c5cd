#include "vox.h"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>

#include <talus/terrain/extraction.h>
#include <catch2/catch.hpp>

#include "scratch_directory.h"
#include "vox_file.h"
#include "vox_reader.h"

using namespace talus;
using namespace talus::tools;

namespace {

// The generator's chunks, one by one and whole, as the vox command may not have them.
class ChunkVoxels {
 public:
  explicit ChunkVoxels(Lod lod) : lod_{lod} {}
  MaterialId at(VoxelPos pos) {
    const ChunkCoord coord = chunk_holding(pos, lod_)->coord;
    auto found = chunks_.find(coord);
    if (found == chunks_.end()) {
      found = chunks_.emplace(coord, generate_chunk(terrain::default_world(), {coord, lod_})).first;
    }
    return found->second.at(local_pos(pos));
  }

 private:
  Lod lod_;
  std::map<ChunkCoord, Chunk> chunks_;
};

vox_reader::Scene scene_of(const terrain::Region& region, VoxOptions options = {}) {
  const ScratchDirectory scratch;
  ProgressBar progress{"vox", "models"};
  REQUIRE(write_vox(terrain::default_world(), region, scratch / "a.vox", options, progress));
  CHECK(scratch.file_count() == 1);
  return vox_reader::read(read_whole(scratch / "a.vox"));
}

struct Bounds {
  std::int64_t lowest_ground = 0;
  std::int64_t highest = 0;
};

Bounds bounds_of(ChunkVoxels& chunks, const terrain::Region& region, std::int64_t high) {
  Bounds bounds{high, 0};
  for (std::int64_t z = region.z; z < region.z + region.depth; ++z) {
    for (std::int64_t x = region.x; x < region.x + region.width; ++x) {
      std::int64_t y = high;
      while (chunks.at({x, y - 1, z}) == kAir) --y;
      bounds.highest = std::max(bounds.highest, y);
      while (chunks.at({x, y - 1, z}) == kWater) --y;
      bounds.lowest_ground = std::min(bounds.lowest_ground, y);
    }
  }
  return bounds;
}

// Every voxel of the region is in the scene with its material where it can be seen, and nowhere else.
void check_scene(const terrain::Region& region, std::size_t models, int depth = 9) {
  const vox_reader::Scene scene = scene_of(region, {.depth = depth});
  CHECK(scene.models == models);
  ChunkVoxels chunks{region.lod};
  const std::int64_t high = (height_range(terrain::default_world()).high >> region.lod.value()) + 1;
  const Bounds bounds = bounds_of(chunks, region, high);
  const std::int64_t bottom = bounds.lowest_ground - depth;
  // What shows a voxel: air shows all, water all but water, and so do the region's sides.
  const auto shows = [&](MaterialId material, VoxelPos beside) {
    if (beside.x < region.x || beside.x >= region.x + region.width) return true;
    if (beside.z < region.z || beside.z >= region.z + region.depth) return true;
    const MaterialId other = chunks.at(beside);
    return other == kAir || (other == kWater && material != kWater);
  };
  std::size_t expected = 0;
  std::size_t wrong = 0;
  for (std::int64_t y = bottom; y < bounds.highest; ++y) {
    for (std::int64_t z = region.z; z < region.z + region.depth; ++z) {
      for (std::int64_t x = region.x; x < region.x + region.width; ++x) {
        const MaterialId material = chunks.at({x, y, z});
        if (material == kAir) continue;
        const bool seen = shows(material, {x + 1, y, z}) || shows(material, {x - 1, y, z}) ||
                          shows(material, {x, y, z + 1}) || shows(material, {x, y, z - 1}) ||
                          shows(material, {x, y + 1, z}) || shows(material, {x, y - 1, z});
        if (!seen) continue;
        ++expected;
        // East is x, north is y, up is z; the middle stands at 0.
        const auto found =
            scene.voxels.find({static_cast<int>(x - region.x) - region.width / 2,
                               region.depth - 1 - static_cast<int>(z - region.z) - region.depth / 2,
                               static_cast<int>(y - bottom)});
        if (found == scene.voxels.end() || found->second != to_integer(material)) ++wrong;
      }
    }
  }
  CHECK(wrong == 0);
  CHECK(expected == scene.voxels.size());
}

}  // namespace

TEST_CASE("A small model holds the voxels of its chunks that can be seen, and no others") {
  check_scene({100, 200, 40, 33, Lod{}}, 1);
}

TEST_CASE("A region over 256 voxels becomes models that the scene joins without a gap") {
  check_scene({-301, -97, 300, 261, Lod{}}, 4);
}

TEST_CASE("A region taller than 256 voxels becomes models that stand on each other") {
  check_scene({-7, -900, 21, 20, Lod{}}, 2, 300);
}

TEST_CASE("A model of a coarse level holds that level's voxels") {
  check_scene({-40, 17, 70, 50, Lod::of(3)}, 1);
}

TEST_CASE("The ends of the world can be written") {
  constexpr std::int64_t kEnd = std::int64_t{1} << 36;
  check_scene({kEnd - 20, -kEnd, 20, 20, Lod{}}, 1);
}

TEST_CASE("A palette index is a material's id and has its colour") {
  const vox_reader::Scene scene = scene_of({0, 0, 8, 8, Lod{}});
  const auto& materials = terrain::default_world().materials();
  for (std::size_t id = 1; id < materials.size(); ++id) {
    const terrain::Colour colour = materials[id].colour;
    CHECK(scene.palette[id] == (0xFF000000U | static_cast<std::uint32_t>(colour.blue) << 16 |
                                static_cast<std::uint32_t>(colour.green) << 8 | colour.red));
  }
  for (std::size_t i = materials.size(); i < 256; ++i) CHECK(scene.palette[i] == 0);
}

TEST_CASE("Water is glass, so that its bed shows, and nothing else is") {
  const vox_reader::Scene scene = scene_of({0, 0, 8, 8, Lod{}});
  REQUIRE(scene.materials.size() == 1);
  const auto& water = scene.materials.at(to_integer(kWater));
  CHECK(water.at("_type") == "_glass");
  for (const char* clarity : {"_weight", "_alpha", "_trans"}) {
    CHECK(std::stod(water.at(clarity)) > 0.5);
    CHECK(std::stod(water.at(clarity)) < 1);
  }
}

TEST_CASE("A model does not depend on threads") {
  const terrain::Region region{-5, -5, 270, 40, Lod{}};
  CHECK(scene_of(region, {.threads = 1}).voxels == scene_of(region, {.threads = 3}).voxels);
}

TEST_CASE("A world of more materials than a palette has colours is refused by number") {
  std::string toml =
      "seed = 1\nresolution = 20\n[surface]\nwavelength = 2\noctaves = 2\ngain = 1\nexponent = 2\n"
      "amplitude = 1\n";
  for (int i = 0; i < 254; ++i) {
    toml += "[[stratified]]\nname = \"rock " + std::to_string(i) +
            "\"\ncolour = \"#808080\"\ndepth = " + std::to_string(2 - 0.004 * i) +
            "\nthickness = 0.1\nroughness = 0.1\n";
  }
  toml +=
      "[[eroded]]\nname = \"grass\"\ncolour = \"#608030\"\nweight = 1\nthickness = 0.1\n"
      "angle_of_repose = 30\nmax_slope = 40\n";
  const auto world = terrain::World::parse(toml, "many.toml");
  INFO((world ? "" : world.error().message));
  REQUIRE(world);
  const ScratchDirectory scratch;
  ProgressBar progress{"vox", "models"};
  const auto outcome = write_vox(*world, {0, 0, 8, 8, Lod{}}, scratch / "a.vox", {}, progress);
  REQUIRE_FALSE(outcome);
  CHECK(outcome.error().message ==
        "--world: a .vox palette has 255 colours, the world has 256 materials, water included; at most 254 "
        "besides water fit");
  CHECK(scratch.file_count() == 0);
}
