#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>

#include "config/command_line.h"
#include "config/fields.h"
#include "config/load.h"

using namespace talus::server;

namespace {

std::string shipped_file() {
  std::ifstream in{TALUS_SOURCE_DIR "/server/talusd.toml"};
  return {std::istreambuf_iterator<char>{in}, {}};
}

std::string toml_error(std::string_view toml) {
  Config config;
  const auto done = apply_toml(config, toml, "file.toml");
  REQUIRE_FALSE(done.has_value());
  return done.error();
}

tl::expected<Command, Exit> command(std::vector<const char*> flags, const Environment& environment = {}) {
  flags.insert(flags.begin(), "talusd");
  return read_command_line(static_cast<int>(flags.size()), flags.data(), environment);
}

std::string other_than_default(const Field& field) {
  if (const auto* number = std::get_if<NumberTarget>(&field.target)) {
    Config defaults;
    return std::to_string(number->at(defaults) == number->most ? number->least : number->most);
  }
  if (std::holds_alternative<NetworksTarget>(field.target)) return "192.0.2.0/24";
  const auto* word = std::get_if<WordTarget>(&field.target);
  if (word == nullptr) return "somewhere:7";
  Config defaults;
  const bool first = word->at(defaults) == word->words.front();
  return std::string{first ? word->words.back() : word->words.front()};
}

}  // namespace

TEST_CASE("talusd.toml says the defaults") {
  const Config defaults;
  Config config;
  config.limits.connections = 1;  // so that the file has to set something
  REQUIRE(apply_toml(config, shipped_file(), "talusd.toml").has_value());
  CHECK(config == defaults);
}

TEST_CASE("talusd.toml has every field") {
  const std::string toml = "\n" + shipped_file();
  for (const Field& field : fields()) {
    const std::size_t dot = field.key.find('.');
    const std::string table =
        dot == std::string_view::npos ? "" : "\n[" + std::string{field.key.substr(0, dot)} + "]";
    const std::string key =
        "\n" + std::string{dot == std::string_view::npos ? field.key : field.key.substr(dot + 1)} + " = ";
    CAPTURE(field.key);
    const std::size_t at = toml.find(table);
    REQUIRE(at != std::string::npos);
    const std::size_t next_table = toml.find("\n[", at + 1);
    CHECK(toml.find(key, at) < next_table);
  }
}

TEST_CASE("every field is set by its variable") {
  for (const Field& field : fields()) {
    CAPTURE(field.key);
    const Config defaults;
    Config config;
    REQUIRE(apply_environment(config, {{variable_name(field), other_than_default(field)}}).has_value());
    CHECK_FALSE(config == defaults);
  }
}

TEST_CASE("the defaults are in range") {
  for (const Field& field : fields()) {
    const auto* number = std::get_if<NumberTarget>(&field.target);
    if (number == nullptr) continue;
    CAPTURE(field.key);
    Config config;
    CHECK(number->at(config) >= number->least);
    CHECK(number->at(config) <= number->most);
  }
}

TEST_CASE("an unknown key names its line and the nearest one") {
  CHECK_THAT(
      toml_error("# first\n[limits]\nidle_timeout = 5\n"),
      Catch::StartsWith("file.toml:3: limits.idle_timeout:") && Catch::Contains("limits.idle_timeout_ms"));
  CHECK_THAT(toml_error("[limit]\nconnections = 5\n"), Catch::StartsWith("file.toml:1: limit:"));
}

TEST_CASE("a number out of range names the range and the unit") {
  CHECK_THAT(toml_error("[limits]\nframe_bytes = 16\n"),
             Catch::StartsWith("file.toml:2: limits.frame_bytes: 16") && Catch::Contains("4096") &&
                 Catch::Contains("(bytes)"));
  CHECK_THAT(toml_error("[limits]\nframe_bytes = -1\n"), Catch::Contains("-1"));
}

TEST_CASE("a value of the wrong type says what would be right") {
  CHECK_THAT(toml_error("listen = 80"), Catch::Contains("listen") && Catch::Contains("HOST:PORT"));
  CHECK_THAT(toml_error("[threads]\nio = 1.5"), Catch::Contains("threads.io") && Catch::Contains("whole"));
  CHECK_THAT(toml_error("limits = 5"), Catch::Contains("[limits]"));
  CHECK_THAT(toml_error("[log]\nlevel = \"loud\""), Catch::Contains("\"debug\""));
}

TEST_CASE("what is no TOML is one line with its place") {
  const std::string line = toml_error("[limits]\nconnections = = 5\n");
  CHECK_THAT(line, Catch::StartsWith("file.toml:2: "));
  CHECK(line.find('\n') == std::string::npos);
}

TEST_CASE("a configuration that cannot be read is one line that names it and says why") {
  const auto line = [](const std::string& file) {
    const auto read = command({"--config", file.c_str()});
    REQUIRE_FALSE(read.has_value());
    CHECK(read.error().status == 1);
    CHECK(std::count(read.error().text.begin(), read.error().text.end(), '\n') == 1);
    CHECK_THAT(read.error().text, Catch::Contains(file));
    return read.error().text;
  };
  CHECK_THAT(line(std::string(5000, 'x')), Catch::Contains("name too long"));
  CHECK_THAT(line(TALUS_SOURCE_DIR), Catch::Contains("directory"));
  CHECK_THAT(line(TALUS_SOURCE_DIR "/server/talusd.toml/x"), Catch::Contains("Not a directory"));
  CHECK_THAT(line("/nowhere/talusd.toml"), Catch::Contains("No such file"));
}

TEST_CASE("flags win over variables, and variables over defaults") {
  const Environment environment{{"TALUS_LISTEN", "host:1"}, {"TALUS_DATA", "kept"}};
  const auto read = command({"--listen", "host:2"}, environment);
  REQUIRE(read.has_value());
  CHECK(read->config.listen == talus::protocol::Endpoint{"host", 2});
  CHECK(read->config.data == "kept");
}

TEST_CASE("a wrong variable is an error that names it") {
  const auto read = command({}, {{"TALUS_LIMITS_CONNECTIONS", "many"}});
  REQUIRE_FALSE(read.has_value());
  CHECK(read.error().status == 1);
  CHECK_THAT(read.error().text, Catch::Contains("TALUS_LIMITS_CONNECTIONS: \"many\""));
}

TEST_CASE("an unknown variable is a warning with the nearest name") {
  const auto read = command({}, {{"TALUS_LISTENER", "x"}});
  REQUIRE(read.has_value());
  REQUIRE(read->warnings.size() == 1);
  CHECK_THAT(read->warnings[0], Catch::Contains("TALUS_LISTEN?"));
}

TEST_CASE("variables of clients are no mistake of the server's") {
  const auto read = command({}, {{"TALUS_TOKEN", "x"}, {"TALUS_TOKEN_FILE", "x"}});
  REQUIRE(read.has_value());
  CHECK(read->warnings.empty());
}

TEST_CASE("--help and --version are no failures") {
  CHECK(command({"--help"}).error().status == 0);
  CHECK(command({"--version"}).error().status == 0);
}

TEST_CASE("A key with more parts than the parser's stack holds is refused in one line") {
  std::string key = "a";
  for (int i = 0; i < 100'000; ++i) key += ".a";
  CHECK(toml_error(key + " = 1") == "file.toml:1: a key of more than 64 parts");
}

TEST_CASE("A path with a zero byte in it is refused") {
  CHECK_THAT(toml_error("data = \"a\\u0000b\""), Catch::Contains("a\\x00b"));
}
