#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cinttypes>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "height_map_file.h"
#include "made_height_map.h"
#include "scratch_directory.h"
#include "talus_gen.h"
#include "world_with_looks.h"
#include "worlds.h"

using talus::test::Outcome;
using talus::test::talus_gen;

namespace {

// One line that says what is wrong.
void check_refused(const std::string& arguments, int exit_code, const std::string& part) {
  const Outcome outcome = talus_gen(arguments);
  INFO(arguments << "\n" << outcome.output << outcome.errors);
  CHECK(outcome.exit_code == exit_code);
  CHECK(outcome.output.empty());
  CHECK(std::count(outcome.errors.begin(), outcome.errors.end(), '\n') == 1);
  CHECK_THAT(outcome.errors, Catch::StartsWith("talus-gen"));
  CHECK_THAT(outcome.errors, Catch::Contains(part));
}

std::string in(const ScratchDirectory& scratch, const std::string& name) {
  return "'" + (scratch / name).string() + "'";
}

}  // namespace

TEST_CASE("talus-gen explains itself") {
  CHECK(talus_gen("--help").exit_code == 0);
  CHECK_THAT(talus_gen("--version").output, Catch::StartsWith("talus-gen "));
  for (const char* command : {"map", "section", "export", "hash", "vox", "gallery", "table1", "likeness",
                              "lod-error", "preview", "find", "quality"}) {
    const Outcome outcome = talus_gen(std::string{command} + " --help");
    CHECK(outcome.exit_code == 0);
    CHECK_THAT(outcome.output, Catch::Contains("--world"));
  }
}

TEST_CASE("Wrong use is one line and exit code 2") {
  const ScratchDirectory scratch;
  const std::string out = " -o " + in(scratch, "a.png");
  check_refused("", 2, "a command is needed");
  check_refused("paint", 2, "paint");
  check_refused("map --size 8,8" + out, 2, "--center");
  check_refused("map --center 0 --size 8,8" + out, 2, "'0' is not a pair of whole numbers");
  check_refused("map --center 0,0 --size 0,8" + out, 2, "--size: 0 is not a length");
  check_refused("map --center 0,0 --size 60000,60000" + out, 2, "60000 x 60000 pixels is too large");
  check_refused("map --center 0,0 --size 8,8 --lod 7" + out, 2, "--lod: ");
  check_refused("map --center 68719476736,0 --size 8,8" + out, 2, "x = 68719476736");
  check_refused("section --from 0,0 --length 0" + out, 2, "--length");
  check_refused("section --from 0,0 --length 9 --axis y" + out, 2, "--axis");
  check_refused("export --origin 0,0 --size 1000000,1000000 -o " + in(scratch, "e"), 2, "GiB");
  check_refused("hash --origin 0,-68719476737 --size 8,8", 2, "z = -68719476737");
  const std::string vox = " -o " + in(scratch, "a.vox");
  check_refused("vox --size 8,8" + vox, 2, "--origin");
  check_refused("vox --origin 0,0 --size 2049,8" + vox, 2, "2049 is not a length from 1 to 2048");
  check_refused("vox --origin 0,0 --size 8,8 --depth 0" + vox, 2, "--depth");
  check_refused("gallery", 2, "--output");
  CHECK(scratch.file_count() == 0);
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
  REQUIRE(talus_gen(erode + "-o " + in(scratch, "made.npy")).exit_code == 0);
  scratch.write("made.png", read_whole(scratch / "made.npy"));  // by its first bytes, not by its name
  const auto eroded = talus_gen("hash --origin -64,0 --size 64,64" + world);
  CHECK(eroded.exit_code == 0);
  CHECK(eroded.output != hash.output);

  scratch.write("made.png", read_whole(scratch / "made.npy").substr(0, 300));
  check_refused("hash --origin 0,0 --size 8,8" + world, 1,
                "surface.height_map.file: 'made.png': has 172 bytes of samples; its shape needs 1334");
  check_refused("hash --origin 0,0 --size 8,8 --world '" TALUS_SOURCE_DIR "/docs/jacksboro.toml'", 1,
                "'jacksboro.png': cannot be read: No such file");
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
  REQUIRE(talus_gen(make + in(scratch, "made.png")).exit_code == 0);
  REQUIRE(talus_gen(make + in(scratch, "again.png")).exit_code == 0);
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
  const Outcome likeness = talus_gen("likeness --seeds 1 -o " + in(scratch, "a.json"));
  CHECK(likeness.exit_code == 0);
  CHECK_THAT(likeness.output, Catch::Contains("mean +- standard deviation of 1 seeds"));
  CHECK_THAT(read_whole(scratch / "a.json"), Catch::Contains("\"thickness_correlation\""));
  const Outcome levels = talus_gen("lod-error --size 128 --center 999,-999 -o " + in(scratch, "b.json"));
  CHECK(levels.exit_code == 0);
  CHECK_THAT(levels.output, Catch::Contains("over 128 x 128 base columns"));
  CHECK_THAT(read_whole(scratch / "b.json"), Catch::Contains("\"same_material_from_above\""));
  check_refused("lod-error --size 100", 2, "--size: 100 is not a multiple of 64");
  check_refused("lod-error --center 68719476736,0", 2, "--center");
  check_refused("likeness --seeds 0", 2, "--seeds");
}

TEST_CASE("find prints a column and its height, and the reason in one line if there is no column") {
  const ScratchDirectory scratch;
  scratch.write("world.toml", talus::test::text_of_world_with_looks());
  const std::string find = "find --near -300,40 --world " + in(scratch, "world.toml");
  const Outcome meadow = talus_gen(find + " --look meadow");
  CHECK(meadow.exit_code == 0);
  std::int64_t x = 0;
  std::int64_t z = 0;
  int height = 0;
  CHECK(std::sscanf(meadow.output.c_str(), "%" SCNd64 ",%" SCNd64 " %d\n", &x, &z, &height) == 3);
  CHECK(std::count(meadow.output.begin(), meadow.output.end(), '\n') == 1);
  CHECK(height > 0);
  CHECK_THAT(talus_gen(find + " --looks").output, Catch::Contains(" %  sea floor\n"));
  check_refused(find + " --look nowhere --within 500", 1,
                "no column with look 'nowhere' within 500 columns of -300,40");
  check_refused(find + " --look fen", 2,
                "no look is named 'fen'; the looks are sea floor, desert, nowhere, meadow");
  check_refused(find, 2, "one of --look and --looks is needed");
  check_refused(find + " --looks --look meadow", 2, "one of --look and --looks is needed");
  check_refused(find + " --look meadow --within 0", 2, "--within");
  check_refused("find --look meadow", 2, "--near");
  check_refused("find --look meadow --near 0", 2, "'0' is not a pair");
  check_refused("find --look meadow --near 68719476736,0", 2, "x = 68719476736");
  check_refused("find --looks --near 0,0 --world '" TALUS_SOURCE_DIR "/core/worlds/canyon.toml'", 1,
                "this world has no looks");
}

TEST_CASE("A map of every Nth column is written for any N from 1 to 4096, and not with --lod") {
  const ScratchDirectory scratch;
  const std::string map = "map --center 0,0 --size 20,10 -o " + in(scratch, "a.png");
  for (const char* every : {"1", "7", "64", "1000", "4096"}) {
    CHECK(talus_gen(map + " --every " + every).exit_code == 0);
  }
  check_refused(map + " --every 0", 2, "--every");
  check_refused(map + " --every 4097", 2, "--every");
  check_refused(map + " --every 64 --lod 2", 2, "excludes");
  check_refused("map --center 68719476735,0 --size 20,10 --every 9 -o " + in(scratch, "b.png"), 2,
                "--center: column x = 68719476824 lies outside the world");
}

TEST_CASE("preview writes a sheet, and refuses in one line") {
  const ScratchDirectory scratch;
  scratch.write("world.toml", talus::test::text_of_world_with_looks());
  const std::string world = " --world " + in(scratch, "world.toml");
  const Outcome sheet = talus_gen("preview --center=-300,40 -o " + in(scratch, "a.png") + world);
  CHECK(sheet.exit_code == 0);
  CHECK((sheet.output + sheet.errors).empty());
  CHECK_THAT(read_whole(scratch / "a.png"), Catch::StartsWith("\x89PNG\r\n"));
  CHECK(scratch.file_count() == 2);
  check_refused("preview" + world, 2, "--output");
  check_refused("preview --center here -o " + in(scratch, "b.png") + world, 2, "'here' is not a pair");
  check_refused("preview --center 68719476735,0 -o " + in(scratch, "b.png") + world, 2,
                "--center: column x = ");
  check_refused("preview -o " + in(scratch, "missing/b.png") + world, 1, "b.png: cannot write");
  check_refused("preview -o " + in(scratch, "b.png") + " --world " + in(scratch, "none.toml"), 1,
                "cannot read the world file");
  CHECK(scratch.file_count() == 2);
}

TEST_CASE("quality prints a table or JSON") {
  const ScratchDirectory scratch;
  // A world that is soon measured; figures of others are quality_test.cpp's.
  const std::string quality = "quality --quick --world '" TALUS_SOURCE_DIR "/core/worlds/classic.toml'";
  const Outcome table = talus_gen(quality);
  CHECK(table.exit_code == 0);
  CHECK_THAT(table.output, Catch::Contains("Wanted in the default world") && Catch::Contains("lone pieces"));
  const Outcome json = talus_gen(quality + " --json");
  CHECK(json.exit_code == 0);
  CHECK_THAT(json.output, Catch::StartsWith("{\n") && Catch::EndsWith("\n}\n"));
  check_refused("quality --quick --world " + in(scratch, "none.toml"), 1, "cannot read the world file");
  check_refused("quality --threads -1", 2, "--threads");
}

TEST_CASE("A command that fails is one line and exit code 1") {
  const ScratchDirectory scratch;
  const std::string map = "map --center 0,0 --size 8,8 ";
  check_refused(map + "-o " + in(scratch, "missing/a.png"), 1, "a.png: cannot write: No such file");
  check_refused(map + "-o " + in(scratch, ""), 1, "is a directory");
  check_refused(map + "-o /dev/null", 1, "/dev/null: is not a regular file");
  check_refused(map + "-o " + in(scratch, "a.png") + " --world " + in(scratch, "none.toml"), 1,
                "none.toml: cannot read the world file: No such file");
  check_refused(map + "-o " + in(scratch, "a.png") + " --world " + in(scratch, ""), 1, "is a directory");
  std::ofstream{scratch / "file"} << "seed = ";
  check_refused(map + "-o " + in(scratch, "a.png") + " --world " + in(scratch, "file"), 1, "file:1");
  check_refused("export --origin 0,0 --size 8,8 -o " + in(scratch, "file"), 1, "cannot make the directory");
  check_refused("vox --origin 0,0 --size 8,8 -o " + in(scratch, "missing/a.vox"), 1, "a.vox: cannot write");
  check_refused("gallery -o " + in(scratch, "file"), 1, "cannot make the directory");
  check_refused("gallery -o " + in(scratch, "g") + " --world " + in(scratch, "file"), 1, "file:1");
  CHECK(scratch.file_count() == 1);
}

TEST_CASE("A pipe without a writer is refused, and does not block") {
  const ScratchDirectory scratch;
  REQUIRE(::mkfifo((scratch / "pipe").c_str(), 0600) == 0);
  const std::string pipe = in(scratch, "pipe");
  check_refused("hash --origin 0,0 --size 8,8 --world " + pipe, 1, "pipe: is not a regular file");
  check_refused("encode " + pipe + " -o " + in(scratch, "a.bin"), 1, "pipe: is not a regular file");
  check_refused("decode " + pipe + " -o " + in(scratch, "a.npy"), 1, "pipe: is not a regular file");
  check_refused("explain " + pipe, 1, "pipe: is not a regular file");
}

TEST_CASE("Negative places are values, not options") {
  const ScratchDirectory scratch;
  CHECK(talus_gen("map --center -5,-7 --size 16,8 -o " + in(scratch, "a.png")).exit_code == 0);
  CHECK(talus_gen("section --from=-5,-7 --length 8 -o " + in(scratch, "b.png")).exit_code == 0);
  CHECK(talus_gen("hash --origin -68719476736,68719476704 --size 32,32").exit_code == 0);
}

TEST_CASE("Commands write what they are asked for, and nothing else") {
  const ScratchDirectory scratch;
  const Outcome map = talus_gen("map --center 0,0 --size 16,8 --lod 2 -o " + in(scratch, "a.png"));
  CHECK(map.exit_code == 0);
  CHECK((map.output + map.errors).empty());
  CHECK_THAT(read_whole(scratch / "a.png"), Catch::StartsWith("\x89PNG\r\n"));
  CHECK(talus_gen("export --origin 0,0 --size 8,8 -o " + in(scratch, "new/deep")).exit_code == 0);
  CHECK(std::filesystem::exists(scratch / "new/deep/export.json"));
  CHECK(scratch.file_count() == 2);
}

TEST_CASE("A hash is 32 hex digits, whatever the threads") {
  const std::string region = "hash --origin -40,7 --size 100,60 --lod 1 --threads ";
  const Outcome one = talus_gen(region + "1");
  CHECK(one.exit_code == 0);
  CHECK(one.output.size() == 33);
  CHECK(one.output.find_first_not_of("0123456789abcdef\n") == std::string::npos);
  CHECK(talus_gen(region + "5").output == one.output);
}
