#include "command_line/connect_options.h"

#include <stdlib.h>

#include <array>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <catch2/catch.hpp>

#include "command_line/parse.h"
#include "scratch_directory.h"

namespace talus::command_line {
namespace {

/// A variable for as long as a test needs it.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_{name} { ::setenv(name, value.c_str(), 1); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;
  ~Variable() { ::unsetenv(name_); }

 private:
  const char* name_;
};

/// What the words after the program's name say, after its variables.
ConnectWords parsed(std::vector<const char*> words) {
  words.insert(words.begin(), "program");
  CLI::App app;
  ConnectWords connect;
  add_connect_options(app, connect);
  REQUIRE_FALSE(parse(app, static_cast<int>(words.size()), words.data()));
  return connect;
}

ConnectWords token_in(const std::string& file) {
  ConnectWords words;
  words.token_file = file;
  return words;
}

std::string token(std::vector<const char*> words) {
  const auto options = read_connect_options(parsed(std::move(words)));
  REQUIRE(options.has_value());
  return options->token;
}

}  // namespace

TEST_CASE("several servers are separated by commas") {
  ConnectWords words;
  words.connect = "ws://a:1,[::1]:2,c:3/talus/v1/stream";
  const auto options = read_connect_options(words);
  REQUIRE(options.has_value());
  CHECK(options->server == protocol::Endpoint{"a", 1});
  CHECK(options->more_servers == std::vector<protocol::Endpoint>{{"::1", 2}, {"c", 3}});
  CHECK(options->websocket.path == "/talus/v1/stream");
  CHECK(more_servers(*options).back().port == "3");
  for (const char* wrong : {"a:1,", ",a:1", "a:1,b", "a:1;b:2", "a:1,b:0"}) {
    words.connect = wrong;
    const auto refused = read_connect_options(words);
    REQUIRE_FALSE(refused.has_value());
    CHECK_THAT(refused.error(), Catch::StartsWith("--connect "));
  }
}

TEST_CASE("a token comes from a file, a word or a variable, and flags win") {
  const ScratchDirectory scratch;
  const std::string file = scratch.write("token",
                                         "\xEF\xBB\xBF"
                                         "from a file\r\n\n");
  CHECK(token({}).empty());
  CHECK(token({"--token-file", file.c_str()}) == "from a file");
  CHECK(token({"--token", "a word"}) == "a word");
  const Variable of_file{"TALUS_TOKEN_FILE", file};
  CHECK(token({}) == "from a file");
  const Variable variable{"TALUS_TOKEN", "a variable"};
  CHECK(token({}) == "a variable");
  CHECK(token({"--token", "a word"}) == "a word");
  CHECK(token({"--token-file", file.c_str()}) == "from a file");
}

TEST_CASE("an invalid token file is one line") {
  const ScratchDirectory scratch;
  for (const std::string& file :
       {std::string{"/nowhere"}, scratch.path().string(), scratch.write("empty", "\n"),
        scratch.write("long", std::string(4097, 'x'))}) {
    const auto none = read_connect_options(token_in(file));
    REQUIRE_FALSE(none.has_value());
    CHECK_THAT(none.error(), Catch::StartsWith("--token-file " + file + ": ") && !Catch::Contains("\n"));
  }
  const std::string longest = scratch.write("longest", std::string(4096, 'x') + "\n");
  CHECK(read_connect_options(token_in(longest))->token.size() == 4096);
}

TEST_CASE("TLS is on with --ca or --tls-name") {
  CHECK_FALSE(read_connect_options(parsed({}))->tls.on);
  CHECK(read_connect_options(parsed({"--tls"}))->tls.on);
  CHECK(read_connect_options(parsed({"--ca", "file"}))->tls.on);
  CHECK(read_connect_options(parsed({"--tls-name", "name"}))->tls.on);
}

TEST_CASE("a WebSocket is asked for by --websocket or by its URL") {
  const auto read = [](std::vector<const char*> words) {
    return read_connect_options(parsed(std::move(words))).value();
  };
  CHECK_FALSE(read({}).websocket.on);
  const ConnectOptions flag = read({"--websocket", "--connect", "a:1"});
  CHECK(flag.websocket.on);
  CHECK(flag.websocket.path == "/v1/stream");
  CHECK_FALSE(flag.tls.on);
  const ConnectOptions plain = read({"--connect", "ws://a:1/"});
  CHECK(plain.websocket.on);
  CHECK_FALSE(plain.tls.on);
  CHECK(plain.websocket.path == "/v1/stream");
  CHECK(plain.server == protocol::Endpoint{"a", 1});
  const ConnectOptions secure = read({"--connect", "wss://[::1]:2/other/stream"});
  CHECK(secure.websocket.on);
  CHECK(secure.tls.on);
  CHECK(secure.websocket.path == "/other/stream");
  CHECK(secure.server == protocol::Endpoint{"::1", 2});
  CHECK_FALSE(read_connect_options(parsed({"--connect", "ws://a"})).has_value());
}

TEST_CASE("an unknown scheme is named, with the known ones") {
  const auto told = [](const char* address) {
    const auto options = read_connect_options(parsed({"--connect", address}));
    REQUIRE_FALSE(options.has_value());
    return options.error();
  };
  const std::string kinds =
      "; write HOST:PORT, with --tls for TLS, or ws://HOST:PORT[/PATH] or wss:// (by TLS)";
  CHECK(told("http://a:1") ==
        "--connect http://a:1: this client does not speak http://, but talusd's HTTP address is reached by "
        "WebSocket" +
            kinds);
  CHECK(told("tcp://a:1/") == "--connect tcp://a:1/: this client does not speak tcp://" + kinds);
  CHECK(told("a:1,ws://b:2") ==
        "--connect a:1,ws://b:2: write ws:// once, before the first address: it is for all of them");
}

TEST_CASE("an invalid server address names the option and the fault") {
  for (const char* text : {"host", "host:0", "::1:80", ":80", "host:x"}) {
    CAPTURE(text);
    const auto address = read_server_address("--connect", text);
    REQUIRE_FALSE(address.has_value());
    CHECK_THAT(address.error(), Catch::StartsWith(std::string{"--connect "} + text + ": "));
  }
  CHECK(read_server_address("--connect", "[::1]:4780") == protocol::Endpoint{"::1", 4780});
}

TEST_CASE("a range rejects an invalid number") {
  CLI::App app;
  double value = 0;
  app.add_option("--value", value)->check(within(0, 5));
  for (const char* text : {"nan", "inf", "-1", "5.1", "x", ""}) {
    CAPTURE(text);
    const std::array words{"program", "--value", text};
    const auto exit = parse(app, 3, words.data());
    REQUIRE(exit);
    CHECK(exit->status == kExitWrongUse);
  }
  const std::array words{"program", "--value", "5"};
  CHECK_FALSE(parse(app, 3, words.data()));
}

}  // namespace talus::command_line
