// Settings from the file, the environment and flags.
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

#include <CLI/CLI.hpp>
#include <catch2/catch.hpp>

#include <talus/toml/toml_bounds.h>

#include "config/command_line.h"
#include "config/fields.h"
#include "config/load.h"
#include "config/parse_flags.h"
#include "scratch_directory.h"

using namespace talus::server;

namespace {

std::string shipped_file() {
  std::ifstream in{TALUS_SOURCE_DIR "/server/talusd.toml"};
  return {std::istreambuf_iterator<char>{in}, {}};
}

std::string toml_error(std::string_view toml) {
  Settings settings;
  const auto done = apply_toml(settings, toml, "file.toml");
  REQUIRE_FALSE(done.has_value());
  CHECK(done.error().find('\n') == std::string::npos);
  return done.error();
}

Settings settings_of(std::string_view toml) {
  Settings settings;
  REQUIRE(apply_toml(settings, toml, "file.toml").has_value());
  return settings;
}

tl::expected<Command, Exit> command(std::vector<const char*> flags, const Environment& environment = {}) {
  flags.insert(flags.begin(), "talusd");
  return read_command_line(static_cast<int>(flags.size()), flags.data(), environment, "0.0.0 (01234567)");
}

std::string other_than_default(const Field& field) {
  if (const auto* number = std::get_if<NumberTarget>(&field.target)) {
    Config defaults;
    return std::to_string(number->at(defaults) == number->max ? number->min : number->max);
  }
  if (std::holds_alternative<PowerOfTwoTarget>(field.target) ||
      std::holds_alternative<OptionalNumberTarget>(field.target)) {
    return "1";
  }
  if (const auto* duration = std::get_if<DurationTarget>(&field.target)) {
    Config defaults;
    return std::to_string((duration->at(defaults) == duration->max ? duration->min : duration->max).count());
  }
  if (std::holds_alternative<NetworksTarget>(field.target)) return "192.0.2.0/24";
  if (std::holds_alternative<BoxesTarget>(field.target)) return "-16,-16:16,16";
  if (std::holds_alternative<OriginsTarget>(field.target)) return "https://play.example";
  if (const auto* urls = std::get_if<UrlsTarget>(&field.target)) {
    return std::string{urls->schemes.front()} + "://10.0.0.1:4222";
  }
  if (const auto* words = std::get_if<WordsTarget>(&field.target)) return std::string{words->words.front()};
  if (const auto* is_on = std::get_if<SwitchTarget>(&field.target)) {
    Config defaults;
    return is_on->at(defaults) ? "false" : "true";
  }
  const auto* word = std::get_if<WordTarget>(&field.target);
  if (word == nullptr) return "somewhere:7";
  Config defaults;
  const bool first = word->at(defaults) == word->words.front();
  return std::string{first ? word->words.back() : word->words.front()};
}

}  // namespace

TEST_CASE("talusd.toml says the defaults") {
  const Config defaults;
  Settings settings;
  settings.config.limits.connections = 1;  // so that the file has to set something
  REQUIRE(apply_toml(settings, shipped_file(), "talusd.toml").has_value());
  CHECK(settings.config == defaults);
  CHECK(settings.warnings.empty());
}

TEST_CASE("wrong flags of a command are reported under its name") {
  const auto told = [](std::vector<const char*> flags) {
    CLI::App app{"", "talusd store"};
    app.require_subcommand(1);
    CLI::App* const history = app.add_subcommand("history", "");
    history->add_option_group("of what")->require_option(1)->add_option("--at");
    history->add_flag("--json");
    flags.insert(flags.begin(), "talusd store");
    const auto exit = parse_flags(app, static_cast<int>(flags.size()), flags.data());
    REQUIRE(exit.has_value());
    CHECK(exit->status == kWrongUse);
    return exit->text;
  };
  CHECK(told({"history"}) ==
        "talusd store history: Exactly 1 option from [--at] is required; see talusd store history --help\n");
  CHECK(told({"history", "--at", "1", "--jso"}) ==
        "talusd store history: not expected: --jso; did you mean --json? See talusd store history --help\n");
  CHECK(told({}).starts_with("talusd store: A subcommand is required: history; see talusd store --help"));
}

TEST_CASE("mistyped words of the command line are reported with a suggestion") {
  const auto told = [](std::vector<const char*> flags) {
    const auto refused = command(std::move(flags));
    REQUIRE_FALSE(refused.has_value());
    CHECK(refused.error().status == kWrongUse);
    return refused.error().text;
  };
  CHECK(told({"stor", "backup"}) == "talusd: unknown command stor; did you mean store? See talusd --help\n");
  CHECK(told({"x\n"}) ==
        "talusd: unknown command x\\x0a; there are token, top, store, cluster, pregen; see talusd --help\n");
  CHECK(told({"--lisen", "a:1"}) ==
        "talusd: not expected: --lisen a:1; did you mean --listen? See talusd --help\n");
  CHECK(told({"--admin", "a:1", "x"}) == "talusd: not expected: x; see talusd --help\n");
}

TEST_CASE("every field is set by its variable") {
  for (const Field& field : fields()) {
    CAPTURE(field.key);
    const Config defaults;
    Settings settings;
    REQUIRE(apply_environment(settings, {{variable_name(field.key), other_than_default(field)}}).has_value());
    CHECK_FALSE(settings.config == defaults);
    CHECK(settings.warnings.empty());
  }
}

TEST_CASE("a switch is true or false, in the file and as a variable") {
  Settings settings;
  REQUIRE(apply_toml(settings, "[http]\ntls = false\npublic_chunks = true\n", "f.toml"));
  CHECK_FALSE(settings.config.http.tls);
  CHECK(settings.config.http.public_chunks);
  for (const auto* text : {"[http]\ntls = 1\n", "[http]\ntls = \"true\"\n"}) {
    const auto wrong = apply_toml(settings, text, "f.toml");
    REQUIRE_FALSE(wrong);
    CHECK_THAT(wrong.error(), Catch::StartsWith("f.toml:2: http.tls: ") && Catch::Contains("true or false"));
  }
}

TEST_CASE("a list of words takes each of its words once") {
  Settings settings;
  REQUIRE(apply_toml(settings, "[secret]\nlayers = [\"veins\"]\n", "f").has_value());
  CHECK(settings.config.secret.layers == std::vector<std::string>{"veins"});
  REQUIRE(apply_environment(settings, {{"TALUS_SECRET_LAYERS", ""}}).has_value());
  CHECK(settings.config.secret.layers.empty());
  for (const char* const wrong : {"[\"caves\"]", "[\"veins\", \"veins\"]", "[1]", "true"}) {
    CAPTURE(wrong);
    const auto refused = apply_toml(settings, std::string{"[secret]\nlayers = "} + wrong + "\n", "f");
    REQUIRE_FALSE(refused.has_value());
    CHECK(refused.error().starts_with("f:2: secret.layers: "));
    CHECK(refused.error().find("give a list of \"veins\"") != std::string::npos);
  }
}

TEST_CASE("every field is written as it is read") {
  for (const Field& field : fields()) {
    CAPTURE(field.key);
    const Config defaults;
    Config changed;
    REQUIRE(set_from_text(field, changed, other_than_default(field)).has_value());
    for (const Config& written : {defaults, changed}) {
      Config read = written == defaults ? changed : defaults;
      REQUIRE(set_from_text(field, read, text_of(field, written)).has_value());
      CHECK(read == written);
    }
  }
  const Networks networks = *Networks::parse("10.0.0.0/8, 192.0.2.7, 2001:db8::/32, ::ffff:192.0.2.1, ::/0");
  CHECK(*Networks::parse(networks.text()) == networks);
}

TEST_CASE("the defaults are in range") {
  for (const Field& field : fields()) {
    CAPTURE(field.key);
    Config config;
    if (const auto* number = std::get_if<NumberTarget>(&field.target)) {
      CHECK(number->at(config) >= number->min);
      CHECK(number->at(config) <= number->max);
    }
    if (const auto* duration = std::get_if<DurationTarget>(&field.target)) {
      CHECK(field.key.ends_with("_ms"));
      CHECK(duration->at(config) >= duration->min);
      CHECK(duration->at(config) <= duration->max);
    }
  }
}

TEST_CASE("an unknown key names its line and the nearest one") {
  CHECK_THAT(
      toml_error("# first\n[limits]\nidle_timeout = 5\n"),
      Catch::StartsWith("file.toml:3: limits.idle_timeout:") && Catch::Contains("limits.idle_timeout_ms"));
  CHECK_THAT(toml_error("[limit]\nconnections = 5\n"), Catch::StartsWith("file.toml:1: limit:"));
}

TEST_CASE("a number that the server chooses by default is auto, which differs from every given number") {
  CHECK_FALSE(Config{}.rates.address_editors);
  CHECK(settings_of("[rates]\naddress_editors = 512\n").config.rates.address_editors == 512);
  CHECK_FALSE(settings_of("[rates]\naddress_editors = \"auto\"\n").config.rates.address_editors);
  const auto by_variable = [](const char* value) {
    return command({}, {{"TALUS_RATES_ADDRESS_EDITORS", value}})->config.rates.address_editors;
  };
  CHECK(by_variable("0") == 0);
  CHECK_FALSE(by_variable("auto"));
  for (const std::string wrong : {"-1", "65537", "\"many\"", "\"512\"", "1.5"}) {
    CHECK_THAT(toml_error("[rates]\naddress_editors = " + wrong + "\n"),
               Catch::StartsWith("file.toml:2: rates.address_editors: ") &&
                   Catch::Contains("a whole number from 0 to 65536 (editors per hour), or \"auto\""));
  }
}

TEST_CASE("a number out of range names the range and the unit") {
  CHECK_THAT(toml_error("[limits]\nframe_bytes = 16\n"),
             Catch::StartsWith("file.toml:2: limits.frame_bytes: 16") && Catch::Contains("4096") &&
                 Catch::Contains("(bytes)"));
  CHECK_THAT(toml_error("[limits]\nframe_bytes = -1\n"), Catch::Contains("-1"));
}

TEST_CASE("the edge of a patch is a power of two, or 0; other values are refused with the nearest two") {
  for (std::uint64_t tiles = 0; tiles <= 17; ++tiles) {
    const std::string toml = "[generation]\npatch_tiles = " + std::to_string(tiles);
    CAPTURE(toml);
    if (std::set<std::uint64_t>{0, 1, 2, 4, 8, 16}.contains(tiles)) {
      CHECK(settings_of(toml).config.generation.patch_tiles == tiles);
    } else {
      CHECK_THAT(toml_error(toml), Catch::StartsWith("file.toml:2: generation.patch_tiles: "));
    }
  }
  const auto error = [](const char* tiles) {
    return toml_error(std::string{"generation.patch_tiles = "} + tiles);
  };
  const std::string begin = "file.toml:1: generation.patch_tiles: ";
  CHECK(error("3") == begin + "3 is wrong; give 2 or 4, the nearest powers of two");
  CHECK(error("9") == begin + "9 is wrong; give 8 or 16, the nearest powers of two");
  CHECK(error("17") == begin + "17 is wrong; give 0, 1, 2, 4, 8, or 16 (tiles)");
  CHECK(command({}, {{"TALUS_GENERATION_PATCH_TILES", "6"}}).error().text ==
        "talusd: TALUS_GENERATION_PATCH_TILES: \"6\" is wrong; give 4 or 8, the nearest powers of two\n");
}

TEST_CASE("a duration is read in milliseconds, in its range") {
  CHECK(settings_of("[limits]\nidle_timeout_ms = 2500").config.limits.idle_timeout ==
        std::chrono::milliseconds{2500});
  CHECK_THAT(
      toml_error("[limits]\nidle_timeout_ms = 9"),
      Catch::StartsWith("file.toml:2: limits.idle_timeout_ms: 9") && Catch::Contains("10 to 86400000 (ms)"));
}

TEST_CASE("a number beyond 64 bits names the key and its range") {
  CHECK_THAT(toml_error("[threads]\nio = 1\n[limits]\n  connections = 99999999999999999999\n"),
             Catch::StartsWith("file.toml:4: limits.connections: ") && Catch::Contains("1 to 1000000"));
}

TEST_CASE("a later error about a setting gets the line or the variable that set it") {
  Settings settings = settings_of("user = \"nobody\"\n[access]\nsecret_file = \"s\"");
  CHECK(settings.origins.locate("user: \"nobody\" is wrong") == "file.toml:1: user: \"nobody\" is wrong");
  CHECK(settings.origins.locate("access.secret_file s: is short") ==
        "file.toml:3: access.secret_file s: is short");
  CHECK(settings.origins.locate("tls.key k: is short") == "tls.key k: is short");
  CHECK(settings.origins.locate("username: x") == "username: x");
  REQUIRE(apply_environment(settings, {{"TALUS_USER", "other"}}).has_value());
  CHECK(settings.origins.locate("user: x") == "TALUS_USER: user: x");
}

TEST_CASE("a setting of a flag has no line in the file") {
  const ScratchDirectory scratch;
  const std::string file = scratch.write("talusd.toml", "admin = \"127.0.0.1:1\"\n");
  const auto read = command({"--config", file.c_str(), "--admin", "127.0.0.1:2"});
  REQUIRE(read.has_value());
  CHECK(read->origins.locate("admin 127.0.0.1:2: in use") == "admin 127.0.0.1:2: in use");
}

TEST_CASE("a value of the wrong type says what would be right") {
  CHECK_THAT(toml_error("listen = 80"), Catch::Contains("listen") && Catch::Contains("HOST:PORT"));
  CHECK_THAT(toml_error("[threads]\nio = 1.0"),
             Catch::Contains("threads.io: the value is a floating-point number; give a whole number"));
  CHECK_THAT(toml_error("limits = 5"), Catch::Contains("[limits]"));
  CHECK_THAT(toml_error("[log]\nlevel = \"loud\""), Catch::Contains("\"debug\""));
}

TEST_CASE("a file in UTF-8 may begin with a byte order mark, and one in UTF-16 is named as such") {
  CHECK(settings_of("\xEF\xBB\xBF[log]\r\nlevel = \"debug\"\r\n").config.log.level == "debug");
  CHECK(toml_error("\xFF\xFEl\0o\0g") ==
        "file.toml:1: the file is in UTF-16; TOML is in UTF-8, so save it as that");
}

TEST_CASE("a syntax error is one line with its place") {
  const std::string line = toml_error("[limits]\nconnections = = 5\n");
  CHECK_THAT(line, Catch::StartsWith("file.toml:2: "));
  CHECK(line.find('\n') == std::string::npos);
}

TEST_CASE("every mistake in a configuration has its message") {
  const std::string long_key(5000, 'k');
  const std::string cut = std::string(120, 'k') + "...";
  struct Mistake {
    std::string toml;
    std::string message;
    std::string was;  // what it said before; "": the same
  };
  const Mistake mistakes[] = {
      {"[limits]\nconnections = \n",
       "file.toml:2: limits.connections: expected value, saw '\\n'; give a whole number from 1 to 1000000 "
       "(connections)",
       "file.toml:2: limits.connections: Error while parsing key-value pair: expected value, saw '\\n'; give "
       "a whole number from 1 to 1000000 (connections)"},
      {"listen == 3", "file.toml:1: listen: this is not a value: a string needs quotes; give \"HOST:PORT\"",
       "file.toml:1: listen: Error while parsing value: could not determine value type; give \"HOST:PORT\""},
      {"foo = {a = 1, a = 2}", "file.toml:1: foo: cannot redefine existing integer 'a'",
       "file.toml:1: Error while parsing key-value pair: cannot redefine existing integer 'a'"},
      {"[limits\n", "file.toml:1: table header: expected ']', saw '\\n'",
       "file.toml:1: Error while parsing table header: expected ']', saw '\\n'"},
      {"# \xe2\x80\xa8\r\n[limits]\r\n\r\nconnections = = 5\r\n",
       "file.toml:4: limits.connections: this is not a value: a string needs quotes; give a whole number "
       "from 1 to 1000000 (connections)",
       "file.toml:4: limits.connections: Error while parsing value: could not determine value type; give a "
       "whole number from 1 to 1000000 (connections)"},
      {long_key + " = 3", "file.toml:1: " + cut + ": no such key", ""},
      {"[limit]\nconnections = 5", "file.toml:1: limit: no such key; did you mean limits?", ""},
      {"port = 5", "file.toml:1: port: no such key", ""},
      {long_key + " = ", "file.toml:1: " + cut + ": encountered end-of-file",
       "file.toml:1: Error while parsing key-value pair: encountered end-of-file"},
      {std::string(talus::kMaxTomlBytes + 1, '#'), "file.toml:1: the file has over 1048576 bytes", ""},
  };
  for (const auto& [toml, message, was] : mistakes) {
    INFO(toml.substr(0, 100));
    CHECK(toml_error(toml) == message);
    CHECK(message != was);
  }
}

TEST_CASE("a path is printed without its control characters") {
  const auto read = command({"--config", "/nowhere/\x1b[2J\n.toml"});
  REQUIRE_FALSE(read.has_value());
  CHECK(read.error().text ==
        "talusd: /nowhere/\\x1b[2J\\x0a.toml: cannot be read: No such file or directory; "
        "give --config a TOML file that talusd may read\n");
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
  const ScratchDirectory scratch;
  const std::string pipe = (scratch.path() / "pipe").string();
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  CHECK_THAT(line(pipe), Catch::Contains("regular file"));
  CHECK_THAT(line("/dev/zero"), Catch::Contains("regular file"));
  CHECK_THAT(line(std::string(5000, 'x')), Catch::Contains("name too long"));
  CHECK_THAT(line(TALUS_SOURCE_DIR), Catch::Contains("regular file"));
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

TEST_CASE("variables for clients cause no warning") {
  const auto read = command({}, {{"TALUS_TOKEN", "x"}, {"TALUS_TOKEN_FILE", "x"}});
  REQUIRE(read.has_value());
  CHECK(read->warnings.empty());
}

TEST_CASE("--help and --version exit with 0") {
  CHECK(command({"--help"}).error().status == 0);
  CHECK(command({"--version"}).error().status == 0);
  CHECK(command({"--version"}).error().text == "talusd 0.0.0 (01234567)\n");
}

TEST_CASE("A key with more parts than the parser's stack holds is refused in one line") {
  std::string key = "a";
  for (int i = 0; i < 100'000; ++i) key += ".a";
  CHECK(toml_error(key + " = 1") == "file.toml:1: a key of more than 64 parts");
}

TEST_CASE("A path with a zero byte in it is refused") {
  CHECK_THAT(toml_error("data = \"a\\u0000b\""), Catch::Contains("a\\x00b"));
  CHECK_THAT(toml_error(std::string{"data\0 = 1", 9}),
             Catch::Contains("\\u0000") && !Catch::Contains("\\x5c") && !Catch::Contains("\\\\"));
}
