// What others send as if it were the stream's, by a real nats-server.
#include <stdexcept>
#include <string>

#include <catch2/catch.hpp>

#include "log_of_tests.h"

using namespace talus::nats_test;
using namespace talus::server;
using namespace talus::server::jetstream;
using namespace std::chrono_literals;

TEST_CASE("a publisher's headers do not replace NATS' own") {
  OneServer one;
  make_stream(one.servers, one.names, 1);
  const auto log = open_log(one.servers.url_list(), one.names);
  publish(*log, "a");
  CHECK(read(*log, 0) == "a");
  send_as_stream(one.servers, one.names.log, "OTHER", 999, "b");
  publish(*log, "c");
  CHECK(read(*log, 1) == "b");
  CHECK(read(*log, 2) == "c");
  // By number, as it is no more to be had by the tail.
  const auto late = open_log(one.servers.url_list(), one.names);
  CHECK(read(*late, 0) == "a");
  CHECK(read(*late, 1) == "b");
  CHECK(read(*late, 2) == "c");
}

TEST_CASE("false messages on the tail subject do no harm after the true ones, and are found before them") {
  OneServer one("max_payload: 64MB");
  make_stream(one.servers, one.names, 1);
  const auto log = open_log(one.servers.url_list(), one.names);
  publish(*log, "a");
  CHECK(read(*log, 0) == "a");
  const auto attacker = connected_to(one.servers.url_list());
  const auto forge = [&](const std::string& stream, std::uint64_t sequence, std::string_view text) {
    send_as_stream(one.servers, one.names.tail, stream, sequence, text);
  };

  SECTION("of another stream, without a number, too large, of a far number, or of one that was read") {
    REQUIRE(attacker->send(one.names.tail, "nowhere", "no header"));
    forge("OTHER", 2, "false");
    forge(one.names.stream, 0, "false");
    forge(one.names.stream, 1'000'000'000'000, "false");
    forge(one.names.stream, 1, "false");
    const auto until = from_now(kPatience);
    forge(one.names.stream, 2, std::string(16U << 20U, 'x'));
    while (log->figures().false_messages < 4) {
      REQUIRE(std::chrono::steady_clock::now() < until);
      REQUIRE(log->next(1, from_now(10ms)));
    }
    // NATS may end the connection of who does not send or take it at once.
    try {
      forge(one.names.stream, 2, std::string(60U << 20U, 'x'));
    } catch (const std::runtime_error& ended) {
      WARN(ended.what());
    }
    publish(*log, "b");
    CHECK(read(*log, 1) == "b");
    publish(*log, "c");
    std::uint64_t after = 1;
    std::string text;
    do text = read(*log, after++);
    while (text == "b");  // twice, where its first acknowledgement did not come
    CHECK(text == "c");
  }
  SECTION("instead of the next one, and it may be invalid") {
    forge(one.names.stream, 2, "false");
    CHECK(read(*log, 1) == "false");
    log->ask_again();
    forge(one.names.stream, 2, "false again");
    publish(*log, "b");
    CHECK(read(*log, 1) == "b");
    CHECK(log->figures().false_messages == 1);
    publish(*log, "c");
    CHECK(read(*log, 2) == "c");
  }
  SECTION("in place of the next one") {
    forge(one.names.stream, 2, "false");
    CHECK(read(*log, 1) == "false");
    SECTION("and another server publishes") {
      const auto other = open_log(one.servers.url_list(), one.names);
      publish(*other, "b");
      const auto failure = read_failure(*log, 2);
      CHECK(failure.kind == Kind::false_message);
      CHECK_THAT(failure.reason, Catch::Contains(one.names.tail));
      CHECK(publish_failure(*log).kind == Kind::false_message);
    }
    SECTION("and this one does") {
      (void)log->publish(bytes_of("b"));  // may fail by the same
      const auto failure = read_failure(*log, 2);
      CHECK((failure.kind == Kind::other || failure.kind == Kind::false_message));
      CHECK_THAT(failure.reason, Catch::Contains(one.names.tail));
    }
  }
}
