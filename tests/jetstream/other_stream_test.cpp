// A stream that is missing, is another, or keeps less than is wanted, by real nats-servers.
#include <memory>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "cluster/jetstream/stream_settings.h"
#include "log_of_tests.h"
#include "server/logged_lines.h"

using namespace talus::nats_test;
using namespace talus::server;
using namespace talus::server::jetstream;
using namespace std::chrono_literals;

TEST_CASE("a stream that is missing is for a person, until it is made") {
  OneServer one;
  const auto log = open_log(one.servers.url_list(), one.names);
  const auto failure = read_failure(*log, 0);
  CHECK(failure.kind == Kind::refused);
  CHECK_THAT(failure.reason, Catch::Contains("talusd cluster init") && Catch::Contains(one.names.stream));
  const auto state = log->state();
  REQUIRE_FALSE(state);
  CHECK(state.error().kind == Kind::refused);
  make_stream(one.servers, one.names, 1);
  CHECK(publish(*log, "a") == 1);
  CHECK(read(*log, 0) == "a");
}

TEST_CASE("servers without JetStream are for a person") {
  NatsServers servers{{.servers = 1, .jetstream = false}};
  const auto log = open_log(servers.url_list(), test_names());
  const auto state = log->state();
  REQUIRE_FALSE(state);
  CHECK(state.error().kind != Kind::other);
  CHECK_FALSE(log->publish(bytes_of("a")));
}

TEST_CASE("a stream that was deleted and made anew is another one") {
  OneServer one;
  make_stream(one.servers, one.names, 1);
  const auto log = open_log(one.servers.url_list(), one.names);
  REQUIRE(log->state());
  publish(*log, "a");
  publish(*log, "b");
  CHECK(read(*log, 0) == "a");
  CHECK(read(*log, 1) == "b");
  ask(one.servers, "$JS.API.STREAM.DELETE." + one.names.stream);
  make_stream(one.servers, one.names, 1);

  CHECK(publish_failure(*log).kind == Kind::other);
  CHECK(read_failure(*log, 2).kind == Kind::other);
  const auto state = log->state();
  REQUIRE_FALSE(state);
  CHECK(state.error().kind == Kind::other);
  // The one message by which it was found out, and none since.
  for (int i = 0; i < 5; ++i) CHECK(publish_failure(*log).kind == Kind::other);
  const auto other = open_log(one.servers.url_list(), one.names);
  const auto in_it = other->state();
  REQUIRE(in_it);
  CHECK(in_it->last <= 1);
}

TEST_CASE("a server that is deleted with its files, and comes back empty, is noticed") {
  OneServer one;
  make_stream(one.servers, one.names, 1);
  const auto log = open_log(one.servers.url_list(), one.names);
  publish(*log, "a");
  CHECK(read(*log, 0) == "a");
  one.servers.kill(0);
  one.servers.lose_files(0);
  one.servers.start(0);
  CHECK(read_failure(*log, 1).kind == Kind::refused);
}

TEST_CASE("messages that the stream no longer keeps are gone") {
  OneServer one;
  auto settings = wanted_settings(one.names, 1);
  settings["max_msgs"] = 10;
  ask(one.servers, "$JS.API.STREAM.CREATE." + one.names.stream, settings.dump());
  const auto log = open_log(one.servers.url_list(), one.names);
  for (int i = 0; i < 20; ++i) publish(*log, "a");
  const auto failure = read_failure(*log, 3);
  CHECK(failure.kind == Kind::gone);
  CHECK_THAT(failure.reason, Catch::Contains("from 11 on") && Catch::Contains("message 4"));
  CHECK(read(*log, 10) == "a");
}

TEST_CASE("another stream that took the subject is refused by name") {
  OneServer one;
  ask(one.servers, "$JS.API.STREAM.CREATE.FOREIGN",
      R"({"name":"FOREIGN","subjects":["talus.>"],"storage":"file"})");
  const auto log = open_log(one.servers.url_list(), one.names);
  const auto failure = publish_failure(*log);
  CHECK(failure.kind == Kind::refused);
  CHECK_THAT(failure.reason, Catch::Contains("FOREIGN"));
}

TEST_CASE("settings that somebody changes later are logged, once, and the server goes on") {
  OneServer one;
  make_stream(one.servers, one.names, 1);
  const auto lines = std::make_shared<LoggedLines>();
  auto log = JetStreamLog::open({urls_of(one.servers.url_list()), one.names, 1},
                                std::make_shared<const Credentials>(), lines);
  REQUIRE(log);
  const auto state_until = [&](const std::string& text) {
    const auto until = from_now(kPatience);
    while (lines->text().find(text) == std::string::npos) {
      (void)(*log)->state();
      REQUIRE(std::chrono::steady_clock::now() < until);
    }
  };
  CHECK(publish(**log, "a") == 1);
  const auto until_seen = from_now(kPatience);
  while (!(*log)->state()) REQUIRE(std::chrono::steady_clock::now() < until_seen);
  auto settings = wanted_settings(one.names, 1);
  settings["max_bytes"] = 1 << 20;
  ask(one.servers, "$JS.API.STREAM.UPDATE." + one.names.stream, settings.dump());
  state_until("max_bytes is 1048576 and should be 17179869184");
  const std::size_t count = lines->count();
  for (int i = 0; i < 5; ++i) REQUIRE((*log)->state());
  CHECK(lines->count() == count);
  CHECK(publish(**log, "b") == 2);
  ask(one.servers, "$JS.API.STREAM.UPDATE." + one.names.stream, wanted_settings(one.names, 1).dump());
  state_until("as they should be again");
}

TEST_CASE("a message that an account's limit refuses is rejected, and not stored") {
  const auto account = [](std::string_view bytes) {
    return fmt::format(
        "accounts {{ A {{ jetstream: {{ max_file: {}, max_mem: 0 }}, users: [{{ user: a, password: a }}] }} "
        "}}\n"
        "no_auth_user: a\n",
        bytes);
  };
  OneServer one{account("17GB")};
  make_stream(one.servers, one.names, 1);
  const auto log = open_log(one.servers.url_list(), one.names);
  CHECK(publish(*log, "a") == 1);
  CHECK(read(*log, 0) == "a");
  one.servers.reconfigure(account("1KB"));
  const std::string large(4096, 'b');
  const auto until = from_now(kPatience);
  for (;;) {
    const auto published = log->publish(bytes_of(large));
    REQUIRE(std::chrono::steady_clock::now() < until);
    if (published || published.error().kind == Kind::unavailable) continue;
    CHECK(published.error().kind == Kind::rejected);
    CHECK_THAT(published.error().reason, Catch::Contains("resource limits exceeded"));
    break;
  }
}

TEST_CASE("a message that a limit of the stream refuses is rejected, and not stored") {
  using Limit = std::pair<nlohmann::json, std::string>;
  const auto [limit, text] = GENERATE(Limit{{{"max_msgs", 1}}, "maximum messages exceeded"},
                                      Limit{{{"max_bytes", 1000}}, "maximum bytes exceeded"},
                                      Limit{{{"max_msgs_per_subject", 1}, {"discard_new_per_subject", true}},
                                            "maximum messages per subject exceeded"});
  OneServer one;
  auto settings = wanted_settings(one.names, 1);
  settings["discard"] = "new";
  settings.update(limit);
  ask(one.servers, "$JS.API.STREAM.CREATE." + one.names.stream, settings.dump());
  const auto log = open_log(one.servers.url_list(), one.names);
  CHECK(publish(*log, std::string(800, 'a')) == 1);
  const auto rejected = log->publish(bytes_of(std::string(800, 'b')));
  REQUIRE_FALSE(rejected);
  CHECK(rejected.error().kind == Kind::rejected);
  CHECK(rejected.error().reason == "NATS: " + text);
  ask(one.servers, "$JS.API.STREAM.UPDATE." + one.names.stream, wanted_settings(one.names, 1).dump());
  CHECK(publish(*log, "c") == 2);
}
