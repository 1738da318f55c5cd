#include <sys/stat.h>

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include <catch2/catch.hpp>

#include "scratch_directory.h"
#include "talus_gen.h"
#include "world_with_looks.h"

using talus::test::Outcome;
using talus::test::talus_gen;

namespace {

void check_refused(const std::string& arguments, int exit_code, const std::string& part) {
  INFO(arguments);
  talus::test::check_refusal(talus_gen(arguments), "talus-gen", exit_code, part);
}

std::string in(const ScratchDirectory& scratch, const std::string& name) {
  return "'" + (scratch / name).string() + "'";
}

}  // namespace

TEST_CASE("talus-gen explains itself") {
  CHECK(talus_gen("--help").exit_code == 0);
  CHECK_THAT(talus_gen("--version").output, Catch::StartsWith("talus-gen "));
  for (const char* command : {"map", "section", "export", "hash", "vox", "preview", "find"}) {
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
  CHECK(scratch.file_count() == 0);
}

TEST_CASE("find prints a column and its height, and says in one line why there is none") {
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
  check_refused("preview -o " + in(scratch, "b.jpg") + world, 2, "b.jpg: pictures are PNG");
  check_refused("preview --center here -o " + in(scratch, "b.png") + world, 2, "'here' is not a pair");
  check_refused("preview --center 68719476735,0 -o " + in(scratch, "b.png") + world, 2,
                "--center: column x = ");
  check_refused("preview -o " + in(scratch, "missing/b.png") + world, 1, "b.png: cannot write");
  check_refused("preview -o " + in(scratch, "b.png") + " --world " + in(scratch, "none.toml"), 1,
                "cannot read the world file");
  CHECK(scratch.file_count() == 2);
}

TEST_CASE("What cannot be done is one line and exit code 1") {
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
