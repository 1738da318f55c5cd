#include "command_line.h"

#include <catch2/catch.hpp>

namespace talus::cli {
namespace {

tl::expected<CommandLine, command_line::Exit> read(std::vector<const char*> words) {
  words.insert(words.begin(), "talus-client");
  return read_command_line(static_cast<int>(words.size()), words.data(), "0.0.0 (01234567)");
}

void check_wrong_use(const std::vector<const char*>& words, const std::string& part) {
  const auto line = read(words);
  REQUIRE_FALSE(line.has_value());
  CHECK(line.error().status == 2);
  CHECK_THAT(line.error().text, Catch::Contains(part) && !Catch::Contains("\n"));
}

}  // namespace

TEST_CASE("an invalid number is wrong use") {
  for (const char* option : {"--seconds", "--speed", "--height"}) {
    for (const char* value : {"nan", "-nan", "inf", "-1", "x"})
      check_wrong_use({"fly", option, value}, option);
  }
  check_wrong_use({"get", "0", "0", "0", "--timeout", "nan"}, "--timeout");
}

TEST_CASE("a chunk outside the world is wrong use") {
  check_wrong_use({"get", "0", "0", "0", "--lod", "7"}, "--lod: level of detail is 7");
  check_wrong_use({"get", "2147483648", "0", "0"}, "chunk x is 2147483648");
  check_wrong_use({"get", "0", "0", "-1073741825", "--lod", "1"}, "chunk z is -1073741825");
  const auto line = read({"get", "2147483647", "0", "-2147483648"});
  REQUIRE(line.has_value());
  CHECK(std::get<GetOptions>(line->options).key.coord == ChunkCoord{2147483647, 0, -2147483647 - 1});
}

TEST_CASE("a map that leaves the world is wrong use") {
  check_wrong_use({"map", "-o", "m.png", "--size", "64,64", "--center", "0,68719476730"}, "voxel z");
  check_wrong_use({"map", "-o", "m.png", "--center", "9223372036854775807,0"}, "9223372036854775807");
}

TEST_CASE("a flight of more heights than fit in memory is wrong use") {
  check_wrong_use({"fly", "--seconds", "86400", "--speed", "100000"}, "--seconds 86400 at --speed 100000");
  CHECK(read({"fly", "--seconds", "86400"}).has_value());
  CHECK(read({"fly", "--speed", "100000"}).has_value());
}

TEST_CASE("a flight begins where the user says") {
  check_wrong_use({"fly", "--from", "9223372036854775807,0"}, "--from leaves the world");
  check_wrong_use({"fly", "--heading", "400"}, "--heading");
  const auto line = read({"fly", "--from", "-70,12", "--heading", "90"});
  REQUIRE(line.has_value());
  const auto& options = std::get<FlyOptions>(line->options);
  CHECK((options.from->x == -70 && options.from->z == 12));
  CHECK(options.heading == 90);
}

TEST_CASE("mistyped words are reported with a suggestion") {
  check_wrong_use({"fli", "--seconds", "3"}, "unknown command fli; did you mean fly?");
  check_wrong_use({"--conect", "a:1", "fly"}, "not expected: --conect a:1; did you mean --connect?");
}

TEST_CASE("columns of at are pairs") {
  check_wrong_use({"at", "1,2,3"}, "columns: 3 has no z");
  check_wrong_use({"at"}, "columns");
  const auto line = read({"at", "1,-2", "3,4"});
  REQUIRE(line.has_value());
  const auto& columns = std::get<AtOptions>(line->options).columns;
  REQUIRE(columns.size() == 2);
  CHECK((columns[0].z == -2 && columns[1].x == 3));
}

TEST_CASE("only a radius that the user gave is the user's") {
  const auto silent = read({"fly"});
  REQUIRE(silent.has_value());
  CHECK_FALSE(std::get<FlyOptions>(silent->options).radius.has_value());
  const auto given = read({"fly", "--radius", "12"});
  REQUIRE(given.has_value());
  CHECK(std::get<FlyOptions>(given->options).radius == 12);
}

TEST_CASE("a picture's name that is no PNG's is wrong use") {
  check_wrong_use({"map", "-o", "x.jpg"}, "--output x.jpg: pictures are PNG");
  check_wrong_use({"fly", "-o", "x"}, "--output x: pictures are PNG");
  check_wrong_use({"fly", "--view", "x.jpeg"}, "--view x.jpeg: pictures are PNG");
  CHECK(read({"fly", "-o", "x.png", "--view", "y.png"}).has_value());
}

TEST_CASE("help is not a failure") {
  const auto line = read({"get", "--help"});
  REQUIRE_FALSE(line.has_value());
  CHECK(line.error().status == 0);
  CHECK_THAT(line.error().text, Catch::Contains("--timeout"));
}

}  // namespace talus::cli
