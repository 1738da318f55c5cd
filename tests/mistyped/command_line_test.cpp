#include <talus/mistyped/command_line.h>

#include <array>
#include <cstddef>

#include <catch2/catch.hpp>

namespace talus {
namespace {

/// What the words are told, by a program of the commands fly and map.
template <std::size_t N>
std::string told(const std::array<const char*, N>& words) {
  CLI::App app;
  app.require_subcommand(1);
  app.fallthrough();
  std::string connect;
  double seconds = 0;
  app.add_option("--connect", connect);
  app.add_subcommand("fly", "")->add_option("-s,--seconds", seconds);
  app.add_subcommand("map", "");
  try {
    app.parse(static_cast<int>(words.size()), words.data());
  } catch (const CLI::ParseError& error) {
    return describe(app, error);
  }
  return "nothing";
}

}  // namespace

TEST_CASE("a command that there is not is named, with what was meant or what there is") {
  CHECK(told(std::array{"program", "fli"}) == "unknown command fli; did you mean fly?");
  CHECK(told(std::array{"program", "fli", "--seconds", "3"}) == "unknown command fli; did you mean fly?");
  CHECK(told(std::array{"program", "--connect", "a:1", "dig"}) == "unknown command dig; there are fly, map");
  CHECK(told(std::array{"program"}) == "A subcommand is required: fly, map");
}

TEST_CASE("flags that there are not are named in their order, with what was meant by the first") {
  CHECK(told(std::array{"program", "--conect", "a:1"}) ==
        "not expected: --conect a:1; did you mean --connect?");
  CHECK(told(std::array{"program", "fly", "--secnds=3", "east"}) ==
        "not expected: --secnds=3 east; did you mean --seconds?");
  CHECK(told(std::array{"program", "fly", "--wings"}) == "not expected: --wings");
  CHECK(told(std::array{"program", "--seconds", "3", "fly"}) ==
        "not expected: --seconds 3; --seconds stands after fly");
}

TEST_CASE("a value that is not a number is named") {
  CHECK(told(std::array{"program", "fly", "--seconds", "x"}) ==
        "--seconds: 'x' is not a number that it takes");
}

TEST_CASE("all else is as the parser says it") {
  CHECK(told(std::array{"program", "fly", "--seconds"}).find("--seconds") != std::string::npos);
}

}  // namespace talus
