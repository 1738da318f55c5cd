#include "export.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <talus/files/npy_file.h>
#include <talus/terrain/boundary_row.h>
#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/places.h>
#include <talus/terrain/settle.h>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "scratch_directory.h"
#include "worlds.h"

using namespace talus;
using namespace talus::tools;
using talus::files::kNpyHeaderBytes;

namespace {

const terrain::Region kRegion{-1500, -3590, 70, 50, Lod{}};
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
  CHECK(exported().file_count() == 12);
  for (const char* name : {"surface.npy", "slope.npy", "apron.npy", "look.npy"}) {
    CHECK(shape_of(exported() / name) == "(50, 70)");
  }
  CHECK(shape_of(exported() / "place.npy") == shape(json["eroded"].size()));
  CHECK(shape_of(exported() / "eroded.npy") == shape(json["eroded"].size()));
  CHECK(shape_of(exported() / "strata.npy") == shape(json["layers"].size()));
  CHECK(shape_of(exported() / "shown.npy") == shape(json["planes"].size()));
  CHECK(shape_of(exported() / "fields.npy") == shape(json["fields"]["names"].size()));
  CHECK(shape_of(exported() / "voxels.npy") ==
        shape(items_of<std::uint8_t>(exported() / "voxels.npy").size() / kColumns));
}

TEST_CASE("export.json says what the arrays mean") {
  const auto json = exported_json();
  const terrain::World& world = terrain::default_world();
  CHECK(json["fingerprint"] == to_string(world.fingerprint()));
  CHECK(json["fingerprint"].get<std::string>().size() == 32);
  CHECK(json["resolution"] == world.spec().resolution);
  CHECK(json["level"] == 0);
  CHECK(json["origin"] == nlohmann::json({-1500, -3590}));
  CHECK(json["size"] == nlohmann::json({70, 50}));
  CHECK(json["y0"] == 0);
  CHECK(json["halo"] == world.halo());
  CHECK(json["sea_fx"] == *world.sea_fx());
  CHECK(json["slope_of"] == "ground with aprons");
  CHECK(json["fields"]["names"] == terrain::place_names(world));
  CHECK(json["fields"]["scale"] == 65536);
  CHECK(json["looks"] == world.look_names());
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
  CHECK(json.size() == 16);
}

TEST_CASE("objects.json has every object of the region, which voxels.npy shows") {
  const terrain::World& world = terrain::default_world();
  const auto json = nlohmann::json::parse(read_whole(exported() / "objects.json"));
  const terrain::Stacks stacks = terrain::generate_stacks(world, kRegion);
  std::size_t inside = 0;
  for (const terrain::PlacedObject& object : stacks.objects) {
    if (object.x < kRegion.x || object.x >= kRegion.x + kRegion.width) continue;
    if (object.z < kRegion.z || object.z >= kRegion.z + kRegion.depth) continue;
    ++inside;
    CHECK(std::any_of(json.begin(), json.end(), [&](const auto& told) {
      return told["kind"] == world.object_kinds()[object.kind].name && told["x"] == object.x &&
             told["y"] == object.y && told["z"] == object.z && told["turn"] == object.turn;
    }));
  }
  CHECK(json.size() == inside);
}

TEST_CASE("export.json documents every array as it is") {
  const auto json = exported_json();
  CHECK(json["arrays"].size() + 2 == exported().file_count());
  for (const auto& [file, array] : json["arrays"].items()) {
    CAPTURE(file);
    const std::string header = read_whole(exported() / file).substr(0, kNpyHeaderBytes);
    const std::map<std::string, std::string> types{{"int32", "<i4"}, {"uint8", "|u1"}, {"uint16", "<u2"}};
    CHECK_THAT(header, Catch::Contains("'" + types.at(array["dtype"]) + "'"));
    std::string numbers;
    for (const std::size_t length : array["shape"]) numbers += std::to_string(length) + ", ";
    numbers.resize(numbers.size() - 2);
    CHECK(shape_of(exported() / file) == "(" + numbers + ")");
    const auto axes = array["axes"].get<std::string>();
    CHECK(static_cast<std::size_t>(std::count(axes.begin(), axes.end(), '[')) == array["shape"].size());
    CHECK_FALSE(array["unit"].get<std::string>().empty());
    CHECK_FALSE(array["meaning"].get<std::string>().empty());
  }
}

TEST_CASE("The planes of an export rise to the surface") {
  const auto surface = items_of<std::int32_t>(exported() / "surface.npy");
  const auto strata = items_of<std::int32_t>(exported() / "strata.npy");
  REQUIRE(strata.size() >= kColumns);
  CHECK(std::equal(surface.begin(), surface.end(), strata.end() - kColumns));
  for (std::size_t i = kColumns; i < strata.size(); ++i) REQUIRE(strata[i] >= strata[i - kColumns]);
}

TEST_CASE("Exported voxels are the chunks' voxels, and everything above them is air") {
  // Desert, forest with its trees, the forest from afar, and the shore of the small world at y = 0.
  const terrain::World small = test::small_world(5);
  struct Case {
    const terrain::World* world;
    terrain::Region region;
  };
  for (const auto& [world, region] : {Case{&terrain::default_world(), kRegion},
                                      Case{&terrain::default_world(), {-2630, 370, 45, 40, Lod{}}},
                                      Case{&terrain::default_world(), {-1315, 185, 45, 40, Lod::of(1)}},
                                      Case{&small, {-20, -20, 45, 40, Lod::of(3)}}}) {
    const int level = region.lod.value();
    CAPTURE(level, region.x);
    const ScratchDirectory scratch;
    ProgressBar progress{"export", "columns"};
    REQUIRE(export_region(*world, region, scratch.path(), {.patch_edge = 30}, progress));
    const auto voxels = items_of<std::uint8_t>(scratch / "voxels.npy");
    const std::int64_t y0 = level == 0 ? 0 : -1;
    const auto rows = static_cast<std::int64_t>(voxels.size() / region.columns());
    for (std::int64_t z = region.z; z < region.z + region.depth; z += 3) {
      for (std::int64_t x = region.x; x < region.x + region.width; x += 4) {
        // From one row of chunks to one past the last.
        for (std::int64_t y = floor_div(y0, kChunkSize) * kChunkSize; y <= y0 + rows + kChunkSize;
             y += kChunkSize) {
          const Chunk chunk = generate_chunk(*world, *chunk_holding({x, y, z}, region.lod));
          for (std::int64_t row = std::max(y, y0); row < y + kChunkSize; ++row) {
            const std::uint16_t expected = to_integer(chunk.at(local_pos({x, row, z})));
            const auto index = static_cast<std::size_t>(
                ((row - y0) * region.depth + (z - region.z)) * region.width + (x - region.x));
            REQUIRE(expected == (row < y0 + rows ? voxels[index] : 0));
          }
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
  CHECK(scratch.file_count() == 12);
  for (const auto& file : std::filesystem::directory_iterator{exported().path()}) {
    CAPTURE(file.path().filename().string());
    const bool same = read_whole(scratch.path() / file.path().filename()) == read_whole(file.path());
    CHECK(same);
  }
}

TEST_CASE("No array of an earlier export stays that is not of the last one") {
  const ScratchDirectory scratch;
  scratch.write("apron.npy", "of another world");
  scratch.write("look.npy", "of another world");
  auto world = terrain::World::parse(test::small_caves_text(3, 2), "small.toml");
  REQUIRE(world);
  ProgressBar progress{"export", "columns"};
  REQUIRE(export_region(*world, {0, 0, 9, 9, Lod{}}, scratch.path(), {}, progress));
  const auto json = nlohmann::json::parse(read_whole(scratch / "export.json"));
  CHECK(json["slope_of"] == "ground, before erosion");
  CHECK_FALSE(json["arrays"].contains("apron.npy"));
  CHECK_FALSE(json.contains("looks"));
  CHECK(scratch.file_count() == json["arrays"].size() + 1);
}

TEST_CASE("An export past the limit is refused before it makes anything") {
  const ScratchDirectory scratch;
  const auto outcome = export_to(scratch / "out", {.max_bytes = 1000});
  REQUIRE_FALSE(outcome);
  CHECK(outcome.error().exit_code == kExitWrongUse);
  CHECK_THAT(outcome.error().message, Catch::StartsWith("--size: 70 x 50 columns could take "));
  CHECK(scratch.file_count() == 0);
}

namespace {

// A region as a second hand finds it: files, and nothing of the generator.
class ExportedRegion {
 public:
  explicit ExportedRegion(const ScratchDirectory& directory)
      : directory_{&directory}, json_(nlohmann::json::parse(read_whole(directory / "export.json"))) {}

  [[nodiscard]] const nlohmann::json& json() const { return json_; }
  [[nodiscard]] int width() const { return json_["size"][0]; }
  [[nodiscard]] int depth() const { return json_["size"][1]; }
  [[nodiscard]] std::size_t columns() const {
    return static_cast<std::size_t>(width()) * static_cast<std::size_t>(depth());
  }
  /// items[slice][column]
  template <typename Item>
  [[nodiscard]] std::vector<std::vector<Item>> array(const std::string& name) const {
    const std::vector<Item> all = items_of<Item>(*directory_ / name);
    std::vector<std::vector<Item>> slices;
    for (std::size_t from = 0; from < all.size(); from += columns()) {
      slices.emplace_back(all.begin() + static_cast<std::ptrdiff_t>(from),
                          all.begin() + static_cast<std::ptrdiff_t>(from + columns()));
    }
    return slices;
  }

 private:
  const ScratchDirectory* directory_;
  nlohmann::json json_;
};

// The default world without what voxels show beside the method: looks, provinces, talus and `where` stay. Ice
// lies on warmer water, or a place to look at would be far to seek.
const terrain::World& plain_world() {
  static const terrain::World world = [] {
    std::string text = test::sample_world_without("default", {"[caves]", "[[veins]]", "[[object]]"});
    const std::string cold = "below = { temperature = -0.62 }";
    const std::size_t at = text.find(cold);
    REQUIRE(at != std::string::npos);
    text.replace(at, cold.size(), "below = { temperature = -0.22 }");
    auto parsed = terrain::World::parse(text, "plain.toml");
    REQUIRE(parsed);
    return *std::move(parsed);
  }();
  return world;
}

// Mesas with aprons, and mountains with snow and a frozen river, each at two levels, and a frozen shore.
struct Place {
  const char* name;
  std::int64_t x;
  std::int64_t z;
  Lod lod;
};
const std::vector<Place>& places() {
  static const std::vector<Place> places{{"mesas", -1560, -3620, Lod{}},
                                         {"mesas from afar", -1560 / 4, -3620 / 4, Lod::of(2)},
                                         {"mountains", 2930, -1360, Lod{}},
                                         {"mountains from afar", 2930 / 4, -1360 / 4, Lod::of(2)},
                                         {"shore", 4040, -760, Lod{}}};
  return places;
}

const ExportedRegion& found(const Place& place) {
  static std::map<std::string, ScratchDirectory> directories;
  static std::map<std::string, ExportedRegion> all;
  if (const auto known = all.find(place.name); known != all.end()) return known->second;
  const ScratchDirectory& scratch = directories[place.name];
  ProgressBar progress{"export", "columns"};
  REQUIRE(export_region(plain_world(), {place.x, place.z, 80, 64, place.lod}, scratch.path(),
                        {.patch_edge = 40}, progress));
  return all.emplace(place.name, ExportedRegion{scratch}).first->second;
}

// Indices into `eroded`, bottom up: what `planes` has after the layers, less water.
std::vector<std::size_t> bottom_up(const nlohmann::json& json) {
  std::vector<std::size_t> order;
  for (std::size_t p = json["layers"].size(); p + 1 < json["planes"].size(); ++p) {
    std::size_t m = 0;
    while (json["eroded"][m]["id"] != json["planes"][p]) ++m;
    order.push_back(m);
  }
  return order;
}

struct Plane {
  std::int32_t top_fx = 0;
  std::uint16_t shown = 0;
};

// Of columns, from rows of voxels, what the planes say. `ground_row`: where the ground ends at most.
std::uint16_t solid_voxel(const std::vector<Plane>& planes, std::int32_t row, bool coarse,
                          std::int32_t max_row, std::int32_t depth_fx) {
  const std::int32_t ground = std::min(terrain::boundary_row(planes.back().top_fx), max_row);
  if (row >= ground) return 0;
  if (coarse && row == ground - 1) {  // the topmost solid voxel shows what lies near the top of the stack
    std::size_t top = planes.size() - 1;
    while (top > 0 && planes[top - 1].top_fx >= planes.back().top_fx - depth_fx) --top;
    return planes[top].shown;
  }
  std::size_t plane = 0;
  while (plane + 1 < planes.size() && terrain::boundary_row(planes[plane].top_fx) <= row) ++plane;
  return planes[plane].shown;
}

}  // namespace

TEST_CASE("Exported voxels follow from the arrays next to them, near and far") {
  std::set<std::uint16_t> seen;
  std::size_t wet = 0;
  for (const Place& place : places()) {
    CAPTURE(place.name);
    const ExportedRegion& region = found(place);
    const auto& json = region.json();
    const bool coarse = json["level"].get<int>() > 0;
    const auto surface = region.array<std::int32_t>("surface.npy").front();
    const auto eroded = region.array<std::int32_t>("eroded.npy");
    const auto strata = region.array<std::int32_t>("strata.npy");
    const auto shown = region.array<std::uint16_t>("shown.npy");
    const auto voxels = region.array<std::uint8_t>("voxels.npy");
    const auto y0 = json["y0"].get<std::int32_t>();
    const auto sea_fx = json["sea_fx"].get<std::int32_t>();
    const std::int32_t sea_row = terrain::boundary_row(sea_fx);
    // Ground under water at level 0 leaves the topmost voxel of a coarse level to water.
    const std::int32_t depth_fx = 128 >> json["level"].get<int>();
    const std::int32_t wet_fx = coarse ? sea_fx - depth_fx : -1;
    CHECK(y0 == (coarse ? -1 : 0));
    REQUIRE(json["planes"].size() == shown.size());
    REQUIRE(json["planes"].back() == 1);

    std::size_t wrong = 0;
    for (std::size_t i = 0; i < region.columns(); ++i) {
      // From the surface down, then from the bottom up.
      std::vector<Plane> loose;
      std::int32_t top_fx = surface[i];
      const auto order = bottom_up(json);
      for (std::size_t k = order.size(); k-- > 0;) {
        loose.push_back({top_fx, shown[strata.size() + k][i]});
        top_fx = std::max(top_fx - eroded[order[k]][i], 0);
      }
      std::vector<Plane> planes;
      for (std::size_t k = 0; k < strata.size(); ++k) {
        planes.push_back({std::min(strata[k][i], top_fx), shown[k][i]});
      }
      planes.insert(planes.end(), loose.rbegin(), loose.rend());

      const bool is_wet = surface[i] < wet_fx;
      const std::int32_t max_row = is_wet ? sea_row - 1 : std::numeric_limits<std::int32_t>::max();
      for (std::size_t y = 0; y < voxels.size(); ++y) {
        const std::int32_t row = y0 + static_cast<std::int32_t>(y);
        std::uint16_t expected = solid_voxel(planes, row, coarse, max_row, depth_fx);
        if (expected == 0 && row < sea_row) expected = row == sea_row - 1 ? shown.back()[i] : 1;
        wrong += voxels[y][i] != expected ? 1 : 0;
        seen.insert(voxels[y][i]);
      }
      wet += is_wet && terrain::boundary_row(surface[i]) >= sea_row ? 1 : 0;
    }
    CHECK(wrong == 0);
  }
  // The places have what the case is about: colours of provinces, looks, ice, and ground that gives way.
  const auto& materials = plain_world().materials();
  for (const char* name : {"water", "ice", "desert marl", "mountain slate", "scree", "red scree", "snow",
                           "red desert", "tundra"}) {
    const auto material =
        std::find_if(materials.begin(), materials.end(), [&](const auto& one) { return one.name == name; });
    REQUIRE(material != materials.end());
    CAPTURE(name);
    CHECK(seen.contains(to_integer(material->id)));
  }
  CHECK(wet > 0);
}

TEST_CASE("Exported loose material follows from place, slope and aprons") {
  std::size_t raised = 0;
  for (const Place& place : places()) {
    CAPTURE(place.name);
    const ExportedRegion& region = found(place);
    const auto& json = region.json();
    const auto surface = region.array<std::int32_t>("surface.npy").front();
    const auto slope = region.array<std::int32_t>("slope.npy").front();
    const auto apron = region.array<std::int32_t>("apron.npy").front();
    const auto allowed = region.array<std::int32_t>("place.npy");
    const auto eroded = region.array<std::int32_t>("eroded.npy");
    const int level = json["level"];

    std::vector<std::int32_t> top_fx = surface;
    const auto order = bottom_up(json);
    for (std::size_t k = order.size(); k-- > 0;) {
      const std::size_t m = order[k];
      CAPTURE(m);
      const auto& rules = json["eroded"][m];
      const std::int64_t steepest = rules["S_fx"];
      terrain::Field settled{region.width(), region.depth()};
      for (std::size_t i = 0; i < region.columns(); ++i) {
        REQUIRE(allowed[m][i] >= 0);
        REQUIRE(allowed[m][i] <= rules["t_fx"].get<std::int32_t>() >> level);
        settled.values[i] = static_cast<std::int32_t>(std::max<std::int64_t>(steepest - slope[i], 0) *
                                                      allowed[m][i] / steepest);
      }
      terrain::settle(settled, rules["c_fx"]);
      // What lies outside of the region has no say so far inside.
      const int ring =
          ((rules["t_fx"].get<int>() >> level) + rules["c_fx"].get<int>() - 1) / rules["c_fx"].get<int>();
      std::size_t wrong = 0;
      for (int z = ring; z < region.depth() - ring; ++z) {
        for (int x = ring; x < region.width() - ring; ++x) {
          const auto i = static_cast<std::size_t>(z * region.width() + x);
          std::int32_t expected = settled.at(x, z);
          if (rules["name"] == "scree") {
            // Down to the ground without its apron.
            expected = std::max(expected, top_fx[i] - (surface[i] - apron[i]));
            raised += apron[i] > 0 ? 1 : 0;
          }
          wrong += eroded[m][i] != expected ? 1 : 0;
        }
      }
      CHECK(wrong == 0);
      for (std::size_t i = 0; i < region.columns(); ++i) top_fx[i] = std::max(top_fx[i] - eroded[m][i], 0);
    }
    CHECK(std::all_of(apron.begin(), apron.end(), [](std::int32_t fx) { return fx >= 0; }));
  }
  CHECK(raised > 100);
}

TEST_CASE("An exported look is the first whose conditions the exported quantities meet") {
  const auto& spec = plain_world().spec().places;
  std::set<std::uint8_t> seen;
  std::size_t undecided = 0;
  std::size_t columns = 0;
  for (const Place& place : places()) {
    CAPTURE(place.name);
    const ExportedRegion& region = found(place);
    const std::vector<std::string> names = region.json()["fields"]["names"];
    const auto fields = region.array<std::int32_t>("fields.npy");
    const auto look = region.array<std::uint8_t>("look.npy").front();
    const auto quantity = [&](std::size_t number, std::size_t i) {
      const std::string name = number < terrain::kQuantities
                                   ? std::string{terrain::kQuantityNames[number]}
                                   : spec.fields[number - terrain::kQuantities].name;
      const auto at = std::find(names.begin(), names.end(), name) - names.begin();
      return fields[static_cast<std::size_t>(at)][i] / 65536.0;
    };
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < region.columns(); ++i) {
      // Where a quantity is at a limit to the rounding of either, its condition may hold or not.
      std::set<std::uint8_t> possible;
      bool decided = false;
      for (const terrain::LookCase& one : spec.looks.front().cases) {
        bool may_hold = true;
        bool must_hold = true;
        for (const terrain::PlaceCondition& condition : one.conditions) {
          const double past = quantity(condition.quantity, i) - static_cast<float>(condition.limit);
          const double within = condition.above ? past : -past;
          may_hold = may_hold && within >= -1.0 / 65536;
          must_hold = must_hold && within > 1.0 / 65536;
        }
        if (may_hold) possible.insert(one.look);
        decided = must_hold;
        if (decided) break;
      }
      if (!decided) possible.insert(0);
      wrong += possible.contains(look[i]) ? 0 : 1;
      undecided += possible.size() > 1 ? 1 : 0;
      seen.insert(look[i]);
      ++columns;
    }
    CHECK(wrong == 0);
  }
  CHECK(seen.size() >= 6);
  CHECK(undecided * 100 < columns);
}
