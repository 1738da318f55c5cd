// Edits over another world, or the same with other names.
#include <array>
#include <filesystem>
#include <map>
#include <random>
#include <string>

#include <fmt/format.h>
#include <rocksdb/db.h>
#include <catch2/catch.hpp>

#include <talus/store/edit_database.h>
#include <talus/terrain/extraction.h>

#include "commands/store/rename.h"
#include "commands/store/transfer.h"
#include "scratch_directory.h"
#include "whole_stores.h"

namespace talus::server {
namespace {

namespace fs = std::filesystem;

/// The world built into the program, with another seed or not, and what else may be placed.
terrain::World world_of(int seed, const std::string& placeables) {
  const std::string text = fmt::format(R"(
seed = {}
resolution = 50
strata_wavelength = 1.2
[surface]
wavelength = 3.2
octaves = 4
gain = 1.15
exponent = 2
amplitude = 0.5
[[stratified]]
name = "granite"
colour = "#767076"
depth = 1.0
thickness = 0.5
roughness = 0.1
[[stratified]]
name = "slate"
colour = "#555b66"
depth = 0.4
thickness = 0.4
roughness = 0.1
[[eroded]]
name = "scree"
colour = "#888888"
weight = 1
thickness = 0.02
angle_of_repose = 34
max_slope = 40
{})",
                                       seed, placeables);
  auto world = terrain::World::parse(text, "test.toml");
  INFO((world ? "" : world.error().message));
  REQUIRE(world.has_value());
  return *std::move(world);
}

std::string placeable(const std::string& name) {
  return fmt::format("[[placeable]]\nname = \"{}\"\ncolour = \"#aabbcc\"\n", name);
}

MaterialId id_of(const terrain::World& world, std::string_view name) {
  for (const terrain::Material& material : world.materials()) {
    if (material.name == name) return material.id;
  }
  FAIL("no material " << name);
  return kAir;
}

}  // namespace

TEST_CASE("rebased edits stay if they differ from the new ground, with materials by name") {
  const ScratchDirectory scratch;
  const terrain::World old = world_of(1, placeable("planks") + placeable("glass"));
  const terrain::World fresh = world_of(2, placeable("lamp") + placeable("glass") + placeable("planks"));
  REQUIRE(old.fingerprint() != fresh.fingerprint());
  std::map<std::string, MaterialId> materials{{"planks", MaterialId{256}}, {"glass", MaterialId{257}}};
  for (const terrain::Material& material : old.materials()) materials.emplace(material.name, material.id);
  // In the old world chunks in the ground and the sky were edited in all materials.
  std::mt19937_64 random{4};
  const std::array all{kAir, id_of(old, "granite"), id_of(old, "slate"), MaterialId{256}, MaterialId{257}};
  Voxels voxels;
  for (int i = 0; i < 4'000; ++i) {
    const ChunkCoord chunk{static_cast<std::int32_t>(random() % 3),
                           static_cast<std::int32_t>(random() % 3) - 1,
                           static_cast<std::int32_t>(random() % 2)};
    voxels[{chunk, static_cast<std::uint16_t>(random() % 32'768)}] = all[random() % all.size()];
  }
  make_store(scratch / "data", voxels, old.fingerprint(), materials);
  const auto directory = store::DataDirectory::open_store(scratch / "data");
  REQUIRE(directory.has_value());
  const auto rebased = rebase_edits(*directory, fresh, false);
  INFO((rebased ? "" : rebased.error()));
  REQUIRE(rebased.has_value());
  Voxels expected;
  std::uint64_t as_base = 0;
  for (const auto& [at, material] : voxels) {
    const Chunk base = terrain::generate_chunk(fresh, {at.first, Lod{}});
    const LocalPos local{static_cast<std::uint8_t>(at.second % 32),
                         static_cast<std::uint8_t>(at.second / 1024),
                         static_cast<std::uint8_t>(at.second / 32 % 32)};
    if (base.at(local) == material) {
      ++as_base;
    } else {
      expected.emplace(at, material);
    }
  }
  CHECK(as_base > 0);
  CHECK(rebased->as_base == as_base);
  CHECK(voxels_of(scratch / "data") == expected);
  CHECK(voxels_of(rebased->replaced) == voxels);
  const auto store = store::ReadOnlyStore::open(scratch / "data");
  CHECK((*store)->meta().fingerprint == fresh.fingerprint());
  CHECK((*store)->materials().at("planks") == MaterialId{256});
  CHECK((*store)->materials().at("glass") == MaterialId{257});
  CHECK((*store)->materials().at("lamp") == MaterialId{258});
}

TEST_CASE("a world whose new placeable finds all ids taken is refused") {
  std::map<std::string, MaterialId> all;
  for (std::uint32_t id = edits::kFirstBound; id <= UINT16_MAX; ++id) {
    all.emplace(fmt::format("m{}", id), MaterialId{static_cast<std::uint16_t>(id)});
  }
  CHECK(rebased_materials(all, world_of(1, placeable("m300"))).has_value());
  const auto refused = rebased_materials(all, world_of(1, placeable("planks")));
  REQUIRE_FALSE(refused.has_value());
  CHECK_THAT(refused.error(), Catch::Contains("256 to 65535, are taken"));
}

TEST_CASE("a rebase refuses materials that the new world does not name, with their count, or drops them") {
  const ScratchDirectory scratch;
  const terrain::World old = world_of(1, placeable("planks"));
  const terrain::World fresh = world_of(2, "");
  std::map<std::string, MaterialId> materials{{"planks", MaterialId{256}}};
  for (const terrain::Material& material : old.materials()) materials.emplace(material.name, material.id);
  const std::pair in_the_sky{ChunkCoord{0, 40, 0}, std::uint16_t{7}};
  const std::pair beside{ChunkCoord{0, 40, 0}, std::uint16_t{8}};
  make_store(scratch / "data", {{in_the_sky, MaterialId{256}}, {beside, id_of(old, "granite")}},
             old.fingerprint(), materials);
  const auto directory = store::DataDirectory::open_store(scratch / "data");
  const auto refused = rebase_edits(*directory, fresh, false);
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().find("names no planks (1): 1 voxels") != std::string::npos);
  CHECK(voxels_of(scratch / "data").size() == 2);
  for (const bool drop : {false, true}) {
    const auto same = rebase_edits(*directory, old, drop);
    REQUIRE_FALSE(same.has_value());
    CHECK(same.error().find("already belongs to that world") != std::string::npos);
  }
  const auto dropped = rebase_edits(*directory, fresh, true);
  REQUIRE(dropped.has_value());
  CHECK(dropped->unknown == 1);
  CHECK(voxels_of(scratch / "data") == Voxels{{beside, id_of(fresh, "granite")}});
}

TEST_CASE("a world that lost a placeable is refused with the count of its voxels, or they are dropped") {
  const ScratchDirectory scratch;
  const terrain::World old = world_of(1, placeable("planks") + placeable("glass"));
  const terrain::World fresh = world_of(1, placeable("glass"));
  REQUIRE(old.fingerprint() == fresh.fingerprint());
  std::map<std::string, MaterialId> materials{{"planks", MaterialId{256}}, {"glass", MaterialId{257}}};
  // The file called it something else when the server started last: a name is no part of the fingerprint.
  for (const terrain::Material& material : old.materials()) {
    materials.emplace(material.name == "granite" ? "grey stone" : material.name, material.id);
  }
  const ChunkCoord sky{0, 40, 0};
  const Voxels voxels{{{sky, 6}, MaterialId{256}},
                      {{sky, 7}, MaterialId{256}},
                      {{sky, 8}, MaterialId{257}},
                      {{sky, 9}, id_of(old, "granite")}};
  make_store(scratch / "data", voxels, old.fingerprint(), materials);
  const auto directory = store::DataDirectory::open_store(scratch / "data");
  const auto refused = rebase_edits(*directory, fresh, false);
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().find("names no planks (2): 2 voxels") != std::string::npos);
  CHECK(voxels_of(scratch / "data") == voxels);
  const auto dropped = rebase_edits(*directory, fresh, true);
  INFO((dropped ? "" : dropped.error()));
  REQUIRE(dropped.has_value());
  CHECK(dropped->unknown == 2);
  CHECK(dropped->as_base == 0);
  CHECK(voxels_of(scratch / "data") ==
        Voxels{{{sky, 8}, MaterialId{257}}, {{sky, 9}, id_of(old, "granite")}});
  const auto store = store::ReadOnlyStore::open(scratch / "data");
  CHECK((*store)->meta().fingerprint == old.fingerprint());
  CHECK_FALSE((*store)->materials().contains("planks"));
  CHECK((*store)->materials().at("glass") == MaterialId{257});
}

TEST_CASE(
    "a placed material that the same land now generates becomes that material, where the ground differs") {
  const terrain::World world = world_of(1, placeable("glass"));
  const MaterialId granite = id_of(world, "granite");
  // What is generated was called something else, and players placed a material of its name of today.
  std::map<std::string, MaterialId> materials{{"granite", MaterialId{256}}, {"glass", MaterialId{257}}};
  for (const terrain::Material& material : world.materials()) {
    materials.emplace(material.name == "granite" ? "grey stone" : material.name, material.id);
  }
  const ChunkCoord ground{0, -1, 0};
  const ChunkCoord sky{0, 40, 0};
  const Chunk base = terrain::generate_chunk(world, {ground, Lod{}});
  DenseVoxels generated;
  base.copy_to(generated);
  const auto granite_at = std::ranges::find(generated, granite);
  REQUIRE(granite_at != generated.end());
  const auto in_granite = static_cast<std::uint16_t>(granite_at - generated.begin());
  const ScratchDirectory scratch;
  const Voxels voxels{
      {{ground, in_granite}, MaterialId{256}}, {{sky, 7}, MaterialId{256}}, {{sky, 8}, MaterialId{257}}};
  const Voxels expected{{{sky, 7}, granite}, {{sky, 8}, MaterialId{257}}};
  for (const bool drop : {false, true}) {
    const auto path = scratch / (drop ? "dropping" : "keeping");
    make_store(path, voxels, world.fingerprint(), materials);
    const auto directory = store::DataDirectory::open_store(path);
    const auto rebased = rebase_edits(*directory, world, drop);
    INFO((rebased ? "" : rebased.error()));
    REQUIRE(rebased.has_value());
    CHECK(rebased->as_base == 1);
    CHECK(rebased->unknown == 0);
    CHECK(voxels_of(path) == expected);
    CHECK(store::ReadOnlyStore::open(path).value()->materials().at("granite") == granite);
    const auto again = rebase_edits(*directory, world, drop);
    REQUIRE_FALSE(again.has_value());
    CHECK_THAT(again.error(), Catch::Contains("there is nothing to do"));
  }
  // talusd refuses the name though nothing is built of it.
  make_store(scratch / "unused", {{{sky, 8}, MaterialId{257}}}, world.fingerprint(), materials);
  CHECK(rebase_edits(*store::DataDirectory::open_store(scratch / "unused"), world, false).has_value());
  CHECK(voxels_of(scratch / "unused") == Voxels{{{sky, 8}, MaterialId{257}}});
}

TEST_CASE("names are looked at before the voxels are counted, and any text of UTF-8 is one") {
  const ScratchDirectory scratch;
  make_store(scratch / "data", {{{{0, 0, 0}, 1}, MaterialId{256}}});
  const auto directory = store::DataDirectory::open_store(scratch / "data");
  const std::string name = "br\xC3\xA4tt \xE6\x9D\xBF \xF0\x9F\xAA\xB5";
  CHECK(rename_material(*directory, "planks", name) == 1);
  CHECK(store::ReadOnlyStore::open(scratch / "data").value()->materials().at(name) == MaterialId{256});
  // A chunk that cannot be read.
  rocksdb::DB* db = nullptr;
  REQUIRE(rocksdb::DB::Open({}, (scratch / "data" / "db").string(), &db).ok());
  REQUIRE(db->Put({}, store::chunk_key({{0, 0, 0}, Lod{}}), std::string{"damaged"}).ok());
  delete db;
  CHECK_THAT(rename_material(*directory, "plank", "boards").error(),
             Catch::Contains("no material \"plank\""));
  CHECK_FALSE(rename_material(*directory, name, "boards").has_value());
  CHECK(store::ReadOnlyStore::open(scratch / "data").value()->materials().at(name) == MaterialId{256});
}

TEST_CASE("a placed material gets another name, and no other one's") {
  const ScratchDirectory scratch;
  const Voxels voxels{{{{0, 0, 0}, 1}, MaterialId{256}},
                      {{{0, 0, 0}, 2}, MaterialId{256}},
                      {{{1, 0, 0}, 2}, MaterialId{257}}};
  make_store(scratch / "data", voxels);
  const auto directory = store::DataDirectory::open_store(scratch / "data");
  REQUIRE(directory.has_value());
  const auto error = [&](const std::string& from, const std::string& to) {
    const auto renamed = rename_material(*directory, from, to);
    return renamed ? std::string{} : renamed.error();
  };
  const auto refused = [&](const std::string& from, const std::string& to, const std::string& why) {
    CHECK_THAT(error(from, to), Catch::StartsWith("data " + (scratch / "data").string() + ": ") &&
                                    Catch::Contains(why) && !Catch::Contains("\n"));
  };
  refused("plank", "boards", "the store has no material \"plank\"");
  refused("planks", "glass", "\"glass\" is another material of the store");
  refused("planks", "stone", "\"stone\" is another material of the store");
  refused("stone", "boards", "one that the world generates");
  refused("planks", "water", "the world's own");
  refused("planks", "", "a name has 1 to 64 bytes");
  refused("planks", std::string(65, 'x'), "a name has 1 to 64 bytes, this has 65");
  for (const char* const name : {"\xFF", "gr\xFC", "\xC3", "\xED\xA0\x80", "\xC0\xAF"}) {
    refused("planks", name, "a name is text in UTF-8, and this is not");
  }
  CHECK_THAT(error("planks", "a\nb"), Catch::Contains("control characters"));
  CHECK(store::ReadOnlyStore::open(scratch / "data").value()->materials() == kMaterials);
  const auto renamed = rename_material(*directory, "planks", "boards");
  INFO((renamed ? "" : renamed.error()));
  REQUIRE(renamed == 2);
  const auto store = store::ReadOnlyStore::open(scratch / "data");
  std::map<std::string, MaterialId> materials = kMaterials;
  materials.erase("planks");
  materials.emplace("boards", MaterialId{256});
  CHECK((*store)->materials() == materials);
  CHECK((*store)->meta().store_id == ContentHash{3, 4});  // clients keep what they know
  CHECK(voxels_of(scratch / "data") == voxels);
}

}  // namespace talus::server
