// Trees, boulders and bushes: whole wherever they are cut, on the ground, never in it.
#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <talus/terrain/boundary_row.h>
#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/lattice_hash.h>
#include <talus/terrain/voxel_model.h>
#include <talus/terrain/world.h>
#include <talus/terrain/world_files.h>

#include "features/object_models.h"
#include "spec/spec_errors.h"
#include "worlds.h"
#include "wrong_spec.h"

namespace talus::terrain {
namespace {

const std::string kWood =
    "[[object]]\nname = \"oak\"\nmodel = \"broadleaf\"\nspacing = 6\nchance = 1\n"
    "wood = { name = \"oak wood\", colour = \"#6b5136\" }\n"
    "leaves = { name = \"oak leaves\", colour = \"#4a7d33\" }\n";
const std::string kThorns =
    "[[object]]\nname = \"thorn\"\nmodel = \"acacia\"\nspacing = 9\nchance = 0.5\nclumps = \"groves\"\n"
    "wood = { name = \"thorn wood\", colour = \"#6b5136\" }\nleaves = { name = \"oak leaves\" }\n"
    "[[object]]\nname = \"stone\"\nmodel = \"boulder\"\nspacing = 11\nchance = 0.3\nin_water = true\n"
    "stone = { name = \"gravel\" }\n";

const std::string kHuts =
    "[[object]]\nname = \"hut\"\nmodel = \"hut.vox\"\nspacing = 24\nchance = 0.8\n"
    "[object.palette]\n9 = { name = \"oak thatch\", colour = \"#a08040\" }\n"
    "200 = { name = \"oak planks\", colour = \"#806040\" }\n";

/// "hut.vox": one hut that no turn leaves as it is, and one larger than a chunk's half.
const std::vector<VoxelModel>& huts() {
  static const std::vector<VoxelModel> models = [] {
    VoxelModel small{4, 6, 3, {}};
    for (std::uint8_t y = 0; y < 6; ++y) {
      for (std::uint8_t x = 0; x + y < 8 && x < 4; ++x) {
        for (std::uint8_t z = 0; z < 3; ++z) {
          if (x == 3 && z == 2) continue;
          small.voxels.push_back({x, y, z, static_cast<std::uint8_t>(y < 3 ? 200 : 9)});
        }
      }
    }
    VoxelModel large{21, 32, 21, {}};
    for (std::uint8_t i = 0; i < 21; ++i) {
      large.voxels.push_back({i, static_cast<std::uint8_t>(i + 11), 3, 9});
      large.voxels.push_back({10, 0, i, 200});
    }
    return std::vector{small, large};
  }();
  return models;
}

/// "CASTLE.VOX": the largest model, two walls that cross.
VoxelModel castle() {
  constexpr std::uint8_t kMiddle = kMaxModelWidth / 2;
  VoxelModel largest{kMaxModelWidth, kMaxModelHeight, kMaxModelWidth, {}};
  for (std::uint8_t y = 0; y < kMaxModelHeight; ++y) {
    for (std::uint8_t i = 0; i < kMaxModelWidth; ++i) {
      largest.voxels.push_back({i, y, kMiddle, 200});
      largest.voxels.push_back({kMiddle, y, i, 9});
    }
  }
  return largest;
}

WorldFiles with_huts() {
  return {{}, [](const std::string& file) -> tl::expected<std::vector<VoxelModel>, std::string> {
            if (file == "hut.vox") return huts();
            if (file == "CASTLE.VOX") return std::vector{castle()};
            return tl::unexpected{std::string{"is not there"}};
          }};
}

World wooded(const std::string& more = "", const std::string& text = test::small_world_text(7)) {
  auto world = World::parse(text + kWood + more, "wood.toml", with_huts());
  INFO((world ? "" : world.error().message));
  REQUIRE(world.has_value());
  return *std::move(world);
}

bool of_objects(const World& world, MaterialId material) {
  return world.materials()[to_integer(material)].name.find("oak") != std::string::npos;
}

Region any_patch(Lod lod) {
  const std::int64_t end = chunk_limit(lod);
  const auto axis = [&] {
    return *rc::gen::oneOf(rc::gen::inRange<std::int64_t>(-200, 200),
                           rc::gen::element<std::int64_t>(-end, end - 2));
  };
  const std::int64_t x = axis();
  const std::int64_t z = axis();
  return {x * kChunkSize, z * kChunkSize, 2 * kChunkSize, 2 * kChunkSize, lod};
}

TEST_CASE("No model leaves its bounds, and no two of its voxels are one") {
  for (std::size_t kind = 0; kind < kModelKinds; ++kind) {
    std::size_t most = 0;
    for (std::uint64_t seed = 0; seed < 1250; ++seed) {
      const ObjectModel model = make_model(static_cast<ModelKind>(kind), mix64(seed));
      REQUIRE(!model.empty());
      std::set<std::tuple<int, int, int>> places;
      for (const ModelVoxel& voxel : model) {
        REQUIRE(std::abs(voxel.x) <= kObjectReach);
        REQUIRE(std::abs(voxel.z) <= kObjectReach);
        REQUIRE((voxel.y >= -kObjectRoot && voxel.y < kObjectTop));
        places.insert({voxel.x, voxel.y, voxel.z});
      }
      REQUIRE(places.size() == model.size());
      most = std::max(most, model.size());
    }
    CAPTURE(kModelForms[kind].name);
    CHECK(most < 2000);
  }
}

TEST_CASE("An object across chunks is whole from whatever patch it is cut, at every level and end") {
  const World world = wooded(kThorns + kHuts);
  CHECK(world.generator_version() == GeneratorVersion::v3);
  std::size_t seen = 0;
  CHECK(rc::check([&] {
    const Lod lod = Lod::of(*rc::gen::inRange(0, Lod::kMax + 1));
    const Region patch = any_patch(lod);
    const Stacks stacks = generate_stacks(world, patch);
    for (int i = 0; i < 4; ++i) {
      const auto x = static_cast<std::int32_t>(patch.x / kChunkSize) + i % 2;
      const auto z = static_cast<std::int32_t>(patch.z / kChunkSize) + i / 2;
      const MixedRange rows = mixed_range(world, stacks, x, z);
      const MixedRange all = mixed_range(world, lod);
      RC_ASSERT((rows.last <= all.last && rows.first >= all.first));
      for (std::int32_t y = rows.first; y <= rows.last + 1; ++y) {
        const ChunkKey key{{x, y, z}, lod};
        const Chunk chunk = extract_chunk(world, stacks, key.coord);
        RC_ASSERT(chunk == generate_chunk(world, key));
        RC_ASSERT((y <= rows.last || chunk.is_uniform()));
        seen += chunk.overrides().size();
      }
    }
  }));
  CHECK(seen > 10000);
}

TEST_CASE("An object of the largest size is whole, and files' names end in .vox or .VOX") {
  std::string text = test::replaced(kHuts, "hut.vox", "CASTLE.VOX");
  text = test::replaced(text, "spacing = 24\nchance = 0.8", "spacing = 64\nchance = 1");
  auto parsed = World::parse(test::small_world_text(7) + text, "castles.toml", with_huts());
  REQUIRE(parsed.has_value());
  std::size_t seen = 0;
  for (const int level : {0, 1, 4}) {
    const Lod lod = Lod::of(level);
    const Stacks stacks = generate_stacks(*parsed, {-kChunkSize, 0, kChunkSize, kChunkSize, lod});
    const MixedRange rows = mixed_range(*parsed, stacks, -1, 0);
    CHECK(rows.last <= mixed_range(*parsed, lod).last);
    for (std::int32_t y = rows.first; y <= rows.last + 1; ++y) {
      const Chunk chunk = extract_chunk(*parsed, stacks, {-1, y, 0});
      CHECK(chunk == generate_chunk(*parsed, {{-1, y, 0}, lod}));
      CHECK((y <= rows.last || chunk.is_uniform()));
      seen += chunk.overrides().size();
    }
  }
  CHECK(seen > 100);
}

TEST_CASE("Objects fill air above the ground alone, with caves, too") {
  const World world = wooded("", test::small_caves_text(5));
  std::size_t seen = 0;
  CHECK(rc::check([&] {
    const Region patch = any_patch(Lod::of(*rc::gen::inRange(0, 3)));
    const Stacks stacks = generate_stacks(world, patch);
    Stacks bare = stacks;
    bare.objects.clear();
    const auto sea_row = boundary_row(*world.sea_fx() >> patch.lod.value());
    const auto x = static_cast<std::int32_t>(patch.x / kChunkSize);
    const auto z = static_cast<std::int32_t>(patch.z / kChunkSize);
    const MixedRange rows = mixed_range(world, stacks, x, z);
    for (std::int32_t y = rows.first; y <= rows.last; ++y) {
      const Chunk with = extract_chunk(world, stacks, {x, y, z});
      const Chunk without = extract_chunk(world, bare, {x, y, z});
      for (std::size_t i = 0; i < kChunkVolume; ++i) {
        const LocalPos at{static_cast<std::uint8_t>(i % 32), static_cast<std::uint8_t>(i / 1024),
                          static_cast<std::uint8_t>(i / 32 % 32)};
        if (with.at(at) == without.at(at)) continue;
        ++seen;
        const std::int32_t row = y * kChunkSize + at.y;
        RC_ASSERT(of_objects(world, with.at(at)));
        RC_ASSERT(without.at(at) == kAir);
        RC_ASSERT(row >= boundary_row(stacks.tops.back().at(at.x, at.z)));
        RC_ASSERT((row >= sea_row || stacks.is_entrance(at.x, at.z)));
      }
    }
    // No foot stands in an entrance or under water.
    for (const PlacedObject& object : stacks.objects) {
      const auto cx = static_cast<int>((object.x >> patch.lod.value()) - patch.x);
      const auto cz = static_cast<int>((object.z >> patch.lod.value()) - patch.z);
      if (cx < 0 || cz < 0 || cx >= patch.width || cz >= patch.depth) continue;
      RC_ASSERT(!stacks.is_entrance(cx, cz));
      RC_ASSERT(object.y >= boundary_row(*world.sea_fx()));
    }
  }));
  CHECK(seen > 1000);
}

TEST_CASE("An author's model stands as it was drawn, turned, and its lowest layer goes down to the ground") {
  auto parsed = World::parse(test::small_world_text(7) + kHuts, "huts.toml", with_huts());
  REQUIRE(parsed.has_value());
  const World& world = *parsed;
  const Region patch{0, 0, 256, 256, Lod{}};
  const Stacks stacks = generate_stacks(world, patch);
  const auto at = [&](std::int64_t x, std::int64_t y, std::int64_t z) {
    const auto chunk_of = [](std::int64_t v) { return static_cast<std::int32_t>(floor_div(v, kChunkSize)); };
    const auto in = [](std::int64_t v) { return static_cast<std::uint8_t>(v & 31); };
    const Chunk chunk = extract_chunk(world, stacks, {chunk_of(x), chunk_of(y), chunk_of(z)});
    return world.materials()[to_integer(chunk.at({in(x), in(y), in(z)}))].name;
  };
  const std::int64_t sea_row = boundary_row(*world.sea_fx());
  std::set<int> turns;
  std::set<int> variants;
  for (const PlacedObject& object : stacks.objects) {
    const VoxelModel& model = huts().at(object.variant);
    const auto inside = [](std::int64_t v) { return v >= 12 && v < 244; };
    if (!inside(object.x) || !inside(object.z)) continue;
    const bool alone =
        std::none_of(stacks.objects.begin(), stacks.objects.end(), [&](const PlacedObject& other) {
          return !(other == object) && std::abs(other.x - object.x) <= 20 &&
                 std::abs(other.z - object.z) <= 20;
        });
    if (!alone) continue;
    turns.insert(object.turn);
    variants.insert(object.variant);
    for (const auto& [vx, vy, vz, colour] : model.voxels) {
      int x = vx - model.width / 2;
      int z = vz - model.depth / 2;
      for (int turn = 0; turn < object.turn; ++turn) x = std::exchange(z, x) * -1;
      const auto ground =
          boundary_row(stacks.tops.back().at(static_cast<int>(object.x) + x, static_cast<int>(object.z) + z));
      for (int y = vy == 0 ? -4 : vy; y <= vy; ++y) {
        if (object.y + y < std::max<std::int64_t>(ground, sea_row)) continue;
        CHECK(at(object.x + x, object.y + y, object.z + z) == (colour == 9 ? "oak thatch" : "oak planks"));
      }
    }
  }
  CHECK(turns.size() == 4);
  CHECK(variants.size() == 2);
}

TEST_CASE("Errors of models of files") {
  const auto [from, to, message] = GENERATE(values<test::Wrong>({
      {"hut.vox", "tower.vox", "object[0].model: 'tower.vox': is not there"},
      {"spacing = 24", "spacing = 9", "object[0].spacing: 9 is out of range; 10 to 64"},
      {"9 = { name", "8 = { name", "object[0].palette.9: is a colour of 'hut.vox' without a material"},
      {"[object.palette]\n", "[object.palette]\n1 = { name = \"gravel\" }\n",
       "object[0].palette.1: unknown key"},
      {"chance = 0.8\n", "chance = 0.8\nwood = { name = \"gravel\" }\n", "object[0].wood: unknown key"},
      {", colour = \"#a08040\"", "", "no material is named 'oak thatch'"},
  }));
  CAPTURE(to);
  const auto error = [](const std::string& text, const WorldFiles& files) {
    const auto world = World::parse(text, "w.toml", files);
    return world ? "accepted" : world.error().message;
  };
  const std::string land = test::small_world_text(7);
  CHECK_THAT(error(land + test::replaced(kHuts, from, to), with_huts()), Catch::Contains(message));
  CHECK(error(land + kHuts, with_huts()) == "accepted");
  CHECK_THAT(error(land + kHuts, {}), Catch::Contains("models cannot be read here"));
}

TEST_CASE("Objects may stand so thick and no thicker") {
  // A full model is 21 x 21 x 32 voxels and 4 more of root: 36 a column where the next stands 21 on.
  WorldFiles files;
  files.models = [](const std::string&) {
    VoxelModel full{21, 32, 21, {}};
    for (std::uint8_t y = 0; y < 32; ++y) {
      for (std::uint8_t z = 0; z < 21; ++z) {
        for (std::uint8_t x = 0; x < 21; ++x) full.voxels.push_back({x, y, z, 9});
      }
    }
    return std::vector<VoxelModel>{full};
  };
  std::string text = test::small_world_text(7);
  for (int kind = 0; kind < 7; ++kind) {
    text += text_of(
        "[[object]]\nname = \"block ", kind,
        "\"\nmodel = \"b.vox\"\nspacing = 21\nchance = 1\n[object.palette]\n9 = { name = \"gravel\" }\n");
  }
  CHECK(World::parse(text, "w.toml", files).has_value());
  text +=
      "[[object]]\nname = \"one too many\"\nmodel = \"boulder\"\nspacing = 4\nchance = 1\n"
      "stone = { name = \"gravel\" }\n";
  const auto world = World::parse(text, "w.toml", files);
  REQUIRE_FALSE(world.has_value());
  CHECK_THAT(world.error().message, Catch::Contains("object[7].spacing: with this kind 2") &&
                                        Catch::Contains("stand on a column; at most 256"));
}

TEST_CASE("A model's voxels are found by where a level looks") {
  const ObjectModel model = make_model(ModelKind::jungle_tree, 12345);
  const ModelLevels levels{model};
  for (const int level : {1, 2}) {
    const std::int64_t mask = (1 << level) - 1;
    for (int place = 0; place < 64; ++place) {
      const std::array<std::int64_t, 3> at{place & 3, place >> 2 & 3, -(place >> 4)};
      for (const bool front : {false, true}) {
        ObjectModel expected;
        std::copy_if(model.begin(), model.end(), std::back_inserter(expected), [&](const ModelVoxel& v) {
          return (v.part == 0) == front && ((v.x - at[0]) & mask) == 0 && ((v.y - at[1]) & mask) == 0 &&
                 ((v.z - at[2]) & mask) == 0;
        });
        const auto found = levels.at(front, level, at[0], at[1], at[2]);
        CHECK(std::is_permutation(found.begin(), found.end(), expected.begin(), expected.end()));
      }
    }
  }
}

TEST_CASE("Objects that would be single cubes from afar are left out there") {
  for (std::size_t kind = 0; kind < kModelKinds; ++kind) {
    std::vector<ObjectModel> models;
    for (std::uint64_t seed = 0; seed < 32; ++seed) {
      models.push_back(make_model(static_cast<ModelKind>(kind), mix64(seed)));
    }
    CAPTURE(kModelForms[kind].name);
    CHECK(levels_shown(models) == (kModelForms[kind].name == "dead_tree" ? 1 : Lod::kMax + 1));
  }
  // Two cubes touch at the level at which they are neighbours alone.
  const ObjectModel apart{{0, 8, 0, 0}, {2, 8, 0, 0}};
  CHECK(levels_shown({&apart, 1}) == 2);
}

TEST_CASE("A model's voxels are found by their rows") {
  const ObjectModel model = make_model(ModelKind::jungle_tree, 12345);
  const ModelRows rows{model};
  CHECK(rc::check([&] {
    const auto from = *rc::gen::inRange<std::int64_t>(-50, 50);
    const auto to = *rc::gen::inRange<std::int64_t>(-50, 50);
    for (const bool front : {false, true}) {
      ObjectModel expected;
      std::copy_if(model.begin(), model.end(), std::back_inserter(expected),
                   [&](const ModelVoxel& v) { return (v.part == 0) == front && v.y >= from && v.y < to; });
      const auto found = rows.at(front, from, to);
      RC_ASSERT(std::is_permutation(found.begin(), found.end(), expected.begin(), expected.end()));
    }
  }));
}

TEST_CASE("A file that several kinds name is read once") {
  int reads = 0;
  WorldFiles files;
  files.models = [&](const std::string& file) {
    ++reads;
    return with_huts().models(file);
  };
  const std::string barns = test::replaced(kHuts, "\"hut\"", "\"barn\"");
  const std::string materials = "[object.palette]\n9 = { name = \"gravel\" }\n200 = { name = \"gravel\" }\n";
  const std::string more = barns.substr(0, barns.find("[object.palette]")) + materials;
  REQUIRE(World::parse(test::small_world_text(7) + kHuts + more, "w.toml", files).has_value());
  CHECK(reads == 1);
}

TEST_CASE("Another kind of object moves no other, and no ground") {
  const World before = wooded();
  const World after = wooded(kThorns);
  const Region patch{640, -320, 96, 96, Lod{}};
  const Stacks own = generate_stacks(before, patch);
  const Stacks both = generate_stacks(after, patch);
  // Around the patch the farthest reach decides which are known.
  const auto inside = [&](const Stacks& stacks) {
    std::vector<PlacedObject> oaks;
    std::copy_if(stacks.objects.begin(), stacks.objects.end(), std::back_inserter(oaks),
                 [&](const PlacedObject& object) {
                   return object.kind == 0 && object.x >= patch.x && object.x < patch.x + patch.width &&
                          object.z >= patch.z && object.z < patch.z + patch.depth;
                 });
    return oaks;
  };
  REQUIRE(!inside(own).empty());
  REQUIRE(both.objects.size() > own.objects.size());
  CHECK(inside(own) == inside(both));
  CHECK(own.tops.back().values == both.tops.back().values);
  // Kinds have one place in the order of the file.
  CHECK(std::is_sorted(both.objects.begin(), both.objects.end(),
                       [](const PlacedObject& a, const PlacedObject& b) { return a.kind < b.kind; }));
}

TEST_CASE("From above objects show what their voxels show") {
  const World world = wooded(kThorns + kHuts);
  for (const int level : {0, 1, 3}) {
    CAPTURE(level);
    const Lod lod = Lod::of(level);
    const Stacks stacks = generate_stacks(world, {0, 0, kChunkSize, kChunkSize, lod});
    const ObjectTops tops = object_tops(world, stacks);
    const MixedRange rows = mixed_range(world, stacks, 0, 0);
    std::vector<MaterialId> seen(kChunkArea, kAir);
    for (std::int32_t y = rows.first; y <= rows.last; ++y) {
      const Chunk chunk = extract_chunk(world, stacks, {0, y, 0});
      for (std::size_t i = 0; i < kChunkVolume; ++i) {
        const MaterialId voxel =
            chunk.at({static_cast<std::uint8_t>(i % 32), static_cast<std::uint8_t>(i / 1024),
                      static_cast<std::uint8_t>(i / 32 % 32)});
        if (voxel != kAir) seen[i % kChunkArea] = voxel;
      }
    }
    std::size_t covered = 0;
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (tops.materials[i] != kAir) {
        ++covered;
        wrong += tops.materials[i] == seen[i] ? 0 : 1;
      } else if (seen[i] != kAir) {
        wrong += of_objects(world, seen[i]) ? 1 : 0;
      }
    }
    CHECK(covered > 100);
    CHECK(wrong == 0);
  }
}

TEST_CASE("A column of a coarse level shows at most 32 objects, of the kinds that come first") {
  std::string kinds;
  for (int i = 0; i < 6; ++i) {
    kinds += "[[object]]\nname = \"giant " + std::to_string(i) +
             "\"\nmodel = \"jungle_tree\"\nspacing = 4\nchance = 1\nwood = { name = \"gravel\" }\nleaves = { "
             "name = \"gravel\" }\n";
  }
  const auto world = World::parse(test::small_world_text(7) + kinds, "wood.toml");
  REQUIRE(world.has_value());
  const Stacks stacks = generate_stacks(*world, {0, 0, 64, 64, Lod::of(3)});
  std::map<std::pair<std::int64_t, std::int64_t>, int> seen;
  std::set<int> kinds_seen;
  for (const PlacedObject& object : stacks.objects) {
    ++seen[{object.seen_x, object.seen_z}];
    kinds_seen.insert(object.kind);
  }
  int most = 0;
  for (const auto& [column, count] : seen) most = std::max(most, count);
  CHECK(most == 32);
  CHECK(kinds_seen.contains(0));
}

TEST_CASE("The condition `where` decides the number of objects") {
  const auto count = [](const std::string& where) {
    const std::string kind = test::replaced(kWood, "chance = 1\n", "chance = 0.5\n" + where);
    const auto world = World::parse(test::small_world_text(7) + kind, "wood.toml");
    REQUIRE(world.has_value());
    return generate_stacks(*world, {0, 0, 192, 192, Lod{}}).objects.size();
  };
  const std::size_t all = count("");
  CHECK(count("where = { height = [1000, 1001] }\n") == 0);
  const std::size_t gentle = count("where = { slope = [50, 30] }\n");
  CAPTURE(all, gentle);
  CHECK((gentle > 0 && gentle < all));
}

TEST_CASE("Errors of objects") {
  const auto [from, to, message] = GENERATE(values<test::Wrong>({
      {"model = \"broadleaf\"", "model = \"palm\"", "object[0].model: 'palm'"},
      {"spacing = 6", "spacing = 3", "object[0].spacing: 3 is out of range; 4 to 64"},
      {"chance = 1", "chance = 1.1", "object[0].chance: 1.1 is out of range; 0 to 1"},
      {"chance = 1", "chance = 1\nlooks = [\"wood\"]", "no look is named 'wood'"},
      {"chance = 1", "chance = 1\nlooks = []", "a list of 1 to 63 strings"},
      {"chance = 1", "chance = 1\nclumps = \"herds\"", "object[0].clumps: 'herds'"},
      {"chance = 1", "chance = 1\nstone = { name = \"x\" }", "object[0].stone: unknown key"},
      {"{ name = \"oak leaves\", colour = \"#4a7d33\" }", "{ name = \"birch\" }",
       "no material is named 'birch'"},
      {"{ name = \"oak leaves\", colour = \"#4a7d33\" }", "{ name = \"air\" }", "no material is named 'air'"},
      {"{ name = \"oak leaves\", colour = \"#4a7d33\" }", "{ name = \"gravel\", colour = \"#4a7d33\" }",
       "names another material already"},
      {"leaves = ", "leafs = ", "object[0].leafs: unknown key"},
  }));
  CAPTURE(to);
  const std::string text = test::small_world_text(7);
  CHECK_THAT(test::error_of(text + test::replaced(kWood, from, to)), Catch::Contains(message));
  CHECK_THAT(test::error_of(text + kWood + kWood), Catch::Contains("names another object already"));
  CHECK_THAT(test::error_of("method = \"erosion\"\nerosion_steps = 3\n" + text + kWood),
             Catch::Contains("objects stand on ground that stays"));
}

}  // namespace
}  // namespace talus::terrain
