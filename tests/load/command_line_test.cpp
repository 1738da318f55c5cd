#include "command_line.h"

#include <catch2/catch.hpp>

using namespace talus::load;

namespace {

auto read(std::vector<const char*> words) {
  words.insert(words.begin(), "talus-load");
  return read_command_line(static_cast<int>(words.size()), words.data(), "0.0.0 (01234567)");
}

}  // namespace

TEST_CASE("the words that users rely on are taken") {
  const auto options =
      read({"--connect", "host:1", "--players", "7", "--duration", "3", "--speed", "9", "--radius", "5",
            "--horizon", "64", "--json", "f.json", "--fail-if", "p99_ms>50", "--fail-if", "errors>0"});
  REQUIRE(options.has_value());
  CHECK(options->connect.server.host == "host");
  CHECK(options->players == 7);
  CHECK(options->seconds == 3);
  CHECK(options->speed == 9);
  CHECK(options->radius == 5);
  CHECK(options->horizon == 64);
  CHECK(options->json == "f.json");
  CHECK(options->fail_if.size() == 2);
}

TEST_CASE("help and version end well") {
  CHECK(read({"--help"}).error().status == 0);
  CHECK(read({"--help"}).error().text.find("p99_ms") != std::string::npos);
  CHECK(read({"--version"}).error().text.find("talus-load 0.0.0 (01234567)") == 0);
}

TEST_CASE("builders are as many groups as their players make") {
  const auto options = read({"--players", "10", "--edits", "2.5", "--edit-group", "4"});
  REQUIRE(options.has_value());
  CHECK(options->builds());
  CHECK(options->groups == 3);
  CHECK(read({"--edit-in-flight", "2"})->groups == 100);
  CHECK_FALSE(read({"--players", "10"})->builds());
  for (const std::vector<const char*>& words :
       std::vector<std::vector<const char*>>{{"--edits", "0"},
                                             {"--edits", "1", "--edit-in-flight", "1"},
                                             {"--edits", "1", "--edit-group", "65"},
                                             {"--edits", "1", "--model", "fly"},
                                             {"--edits", "1", "--groups", "3"},
                                             {"--edits", "1", "--vertical", "0"},
                                             {"--edits", "1", "--horizon", "64"},
                                             {"--edits", "1", "--players", "0", "--idle", "1"}}) {
    CHECK(read(words).error().status == 2);
  }
}

TEST_CASE("wrong use is one line and 2") {
  const std::vector<std::vector<const char*>> wrongs{
      {"--connect", "nowhere"},  {"--players", "-1"},  {"--duration", "nan"}, {"--model", "run"},
      {"--fail-if", "p99_ms"},   {"--metrics", "x"},   {"--players", "0"},    {"--verify", "101"},
      {"--compare", "/no/such"}, {"--slow-rate", "0"}, {"--no-such-option"},  {"--threads", "0"},
  };
  for (const auto& words : wrongs) {
    CAPTURE(words.front());
    const auto options = read(words);
    REQUIRE_FALSE(options.has_value());
    CHECK(options.error().status == 2);
    CHECK(options.error().text.find('\n') == std::string::npos);
  }
}

TEST_CASE("a horizon lies beyond the radius") {
  CHECK(read({"--horizon", "8", "--radius", "8"}).error().text.find("--horizon 8 is not beyond") == 0);
  CHECK(read({"--horizon", "9", "--radius", "8"}).has_value());
  CHECK(read({"--radius", "8"})->horizon == 0);
}

TEST_CASE("the option whose address is wrong is named") {
  CHECK(read({"--metrics", "x"}).error().text.find("--metrics x:") == 0);
}

TEST_CASE("the last value of an option given twice counts") {
  CHECK(read({"--players", "7", "--players", "8"})->players == 8);
}
