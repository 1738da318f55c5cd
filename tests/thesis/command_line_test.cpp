#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "height_map_file.h"
#include "made_height_map.h"
#include "scratch_directory.h"
#include "talus_thesis.h"
#include "worlds.h"

using talus::test::check_refusal;
using talus::test::Outcome;
using talus::test::talus_thesis;

namespace {

Outcome talus_gen(const std::string& arguments) {
  return talus::test::run_in_shell(TALUS_GEN_PATH, arguments);
}

void check_refused(const std::string& arguments, int exit_code, const std::string& part) {
  INFO(arguments);
  talus::test::check_refusal(talus_thesis(arguments), "talus-thesis", exit_code, part);
}

std::string in(const ScratchDirectory& scratch, const std::string& name) {
  return "'" + (scratch / name).string() + "'";
}

}  // namespace

TEST_CASE("talus-thesis explains itself") {
  CHECK(talus_thesis("--help").exit_code == 0);
  CHECK_THAT(talus_thesis("--version").output, Catch::StartsWith("talus-thesis "));
  for (const char* command : {"gallery", "table1", "likeness", "lod-error", "quality"}) {
    const Outcome outcome = talus_thesis(std::string{command} + " --help");
    CHECK(outcome.exit_code == 0);
    CHECK_THAT(outcome.output, Catch::Contains("--world"));
  }
  check_refused("", 2, "a command is needed: gallery, ");
  check_refused("map --center 0,0 --size 8,8", 2, "unknown command map");
}

TEST_CASE("gallery refuses what it cannot read or write") {
  const ScratchDirectory scratch;
  scratch.write("file", "seed = ");
  check_refused("gallery", 2, "--output");
  check_refused("gallery -o " + in(scratch, "file"), 1, "cannot make the directory");
  check_refused("gallery -o " + in(scratch, "g") + " --world " + in(scratch, "file"), 1, "file:1");
  CHECK(scratch.file_count() == 1);
}

TEST_CASE("A world with a height map is read with the file next to it, and eroded files are such files") {
  const ScratchDirectory scratch;
  using talus::tools::write_height_map;
  const auto made = talus::test::made_height_map();
  REQUIRE(write_height_map(scratch / "made.png", made));
  const std::string spec = talus::test::small_world_text(1, "mirror");
  scratch.write("world.toml", spec);
  const std::string world = " --world " + in(scratch, "world.toml");
  const auto hash = talus_gen("hash --origin -64,0 --size 64,64" + world);
  CHECK(hash.exit_code == 0);
  CHECK(talus_gen("map --center 0,0 --size 20,20 -o " + in(scratch, "m.png") + world).exit_code == 0);
  CHECK(talus_gen("section --from 0,0 --length 20 -o " + in(scratch, "s.png") + world).exit_code == 0);

  const std::string erode = "erode-heightmap " + in(scratch, "made.png") + " --droplets 300 ";
  REQUIRE(talus_thesis(erode + "-o " + in(scratch, "made.npy")).exit_code == 0);
  scratch.write("made.png", read_whole(scratch / "made.npy"));  // by its first bytes, not by its name
  const auto eroded = talus_gen("hash --origin -64,0 --size 64,64" + world);
  CHECK(eroded.exit_code == 0);
  CHECK(eroded.output != hash.output);

  scratch.write("made.png", read_whole(scratch / "made.npy").substr(0, 300));
  check_refusal(talus_gen("hash --origin 0,0 --size 8,8" + world), "talus-gen", 1,
                "surface.height_map.file: 'made.png': has 172 bytes of samples; its shape needs 1334");
  check_refusal(talus_gen("hash --origin 0,0 --size 8,8 --world '" TALUS_SOURCE_DIR "/docs/jacksboro.toml'"),
                "talus-gen", 1, "'jacksboro.png': cannot be read: No such file");
}

TEST_CASE("erode-heightmap refuses what it cannot read or write") {
  const ScratchDirectory scratch;
  REQUIRE(talus::tools::write_height_map(scratch / "a.npy", {2, 2, std::vector<float>{1, 2, 3, 4}}));
  const std::string a = "erode-heightmap " + in(scratch, "a.npy");
  check_refused("erode-heightmap", 2, "input is required");
  check_refused(a, 2, "--output");
  check_refused(a + " --droplets -1 -o " + in(scratch, "b.npy"), 2, "--droplets");
  check_refused(a + " -o " + in(scratch, "b.png"), 2, "give a .npy");
  check_refused(a + " -o " + in(scratch, "b.txt"), 2, "neither .png nor .npy");
  check_refused("erode-heightmap " + in(scratch, "c.npy") + " -o " + in(scratch, "b.npy"), 1,
                "c.npy: cannot be read");
  scratch.write("d.npy", "text");
  check_refused("erode-heightmap " + in(scratch, "d.npy") + " -o " + in(scratch, "b.npy"), 1,
                "neither PNG nor .npy");
  CHECK_FALSE(std::filesystem::exists(scratch / "b.npy"));
}

TEST_CASE("diamond-square-heightmap writes what a world takes, the same each time") {
  const ScratchDirectory scratch;
  const std::string make = "diamond-square-heightmap --seed 5 --size 32 -o ";
  REQUIRE(talus_thesis(make + in(scratch, "made.png")).exit_code == 0);
  REQUIRE(talus_thesis(make + in(scratch, "again.png")).exit_code == 0);
  CHECK(read_whole(scratch / "made.png") == read_whole(scratch / "again.png"));
  scratch.write("world.toml", talus::test::small_world_text(1, "repeat"));
  CHECK(talus_gen("hash --origin -64,0 --size 64,64 --world " + in(scratch, "world.toml")).exit_code == 0);

  const std::string out = " -o " + in(scratch, "b.npy");
  check_refused("diamond-square-heightmap --size 500" + out, 2, "--size: 500 is not a power of two; 8, 16");
  check_refused("diamond-square-heightmap --size 4" + out, 2, "--size");
  check_refused("diamond-square-heightmap --roughness 1.5" + out, 2, "--roughness");
  check_refused("diamond-square-heightmap --size 8 -o " + in(scratch, "b.txt"), 2, "neither .png nor .npy");
  CHECK_FALSE(std::filesystem::exists(scratch / "b.npy"));
}

TEST_CASE("likeness and lod-error print their figures and write them as JSON") {
  const ScratchDirectory scratch;
  const Outcome likeness = talus_thesis("likeness --seeds 1 -o " + in(scratch, "a.json"));
  CHECK(likeness.exit_code == 0);
  CHECK_THAT(likeness.output, Catch::Contains("mean +- standard deviation of 1 seeds"));
  CHECK_THAT(read_whole(scratch / "a.json"), Catch::Contains("\"thickness_correlation\""));
  const Outcome levels = talus_thesis("lod-error --size 128 --center 999,-999 -o " + in(scratch, "b.json"));
  CHECK(levels.exit_code == 0);
  CHECK_THAT(levels.output, Catch::Contains("over 128 x 128 base columns"));
  CHECK_THAT(read_whole(scratch / "b.json"), Catch::Contains("\"same_material_from_above\""));
  check_refused("lod-error --size 100", 2, "--size: 100 is not a multiple of 64");
  check_refused("lod-error --center 68719476736,0", 2, "--center");
  check_refused("likeness --seeds 0", 2, "--seeds");
}

TEST_CASE("quality prints a table or JSON") {
  const ScratchDirectory scratch;
  // A world that is soon measured; figures of others are quality_test.cpp's.
  const std::string quality = "quality --quick --world '" TALUS_SOURCE_DIR "/core/worlds/classic.toml'";
  const Outcome table = talus_thesis(quality);
  CHECK(table.exit_code == 0);
  CHECK_THAT(table.output, Catch::Contains("Wanted in the default world") && Catch::Contains("lone pieces"));
  const Outcome json = talus_thesis(quality + " --json");
  CHECK(json.exit_code == 0);
  CHECK_THAT(json.output, Catch::StartsWith("{\n") && Catch::EndsWith("\n}\n"));
  check_refused("quality --quick --world " + in(scratch, "none.toml"), 1, "cannot read the world file");
  check_refused("quality --threads -1", 2, "--threads");
}
