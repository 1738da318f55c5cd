// What tests of a log by real nats-servers do again and again.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <thread>

#include <catch2/catch.hpp>

#include "opened_stream.h"

namespace talus::nats_test {

using namespace server;
using namespace server::jetstream;
using namespace std::chrono_literals;
using Kind = StreamFailure::Kind;

// An election of NATS takes up to 15 s on a busy machine.
inline constexpr auto kPatience = 60s;
// As the publisher does. Without it some thousand messages a second flood the servers that hold an election.
inline constexpr auto kRetry = 20ms;

inline LogStream::TimePoint from_now(std::chrono::milliseconds time) {
  return std::chrono::steady_clock::now() + time;
}

/// Again and again until a majority has it.
inline std::uint64_t publish(LogStream& log, std::string_view text) {
  const auto until = from_now(kPatience);
  for (;;) {
    const auto sequence = log.publish(bytes_of(text));
    if (sequence) return *sequence;
    INFO(sequence.error().reason);
    REQUIRE(std::chrono::steady_clock::now() < until);
    std::this_thread::sleep_for(kRetry);
  }
}

/// The text of the message after `after`, which comes some time.
inline std::string read(LogStream& log, std::uint64_t after) {
  const auto until = from_now(kPatience);
  for (;;) {
    const auto message = log.next(after, until);
    INFO((message ? std::string{} : message.error().reason));
    REQUIRE(std::chrono::steady_clock::now() < until);
    if (!message && message.error().kind == Kind::unavailable) continue;
    REQUIRE(message);
    if (!*message) continue;
    CHECK((*message)->sequence == after + 1);
    return text_of((*message)->bytes);
  }
}

/// Why next() fails for good; it may work until it notices.
inline StreamFailure read_failure(LogStream& log, std::uint64_t after) {
  const auto until = from_now(kPatience);
  for (;;) {
    const auto message = log.next(after, from_now(100ms));
    if (!message && message.error().kind != Kind::unavailable) return message.error();
    REQUIRE(std::chrono::steady_clock::now() < until);
  }
}

/// Why publish() fails for good.
inline StreamFailure publish_failure(LogStream& log) {
  const auto until = from_now(kPatience);
  for (;;) {
    const auto published = log.publish(bytes_of("a"));
    if (!published && published.error().kind != Kind::unavailable) return published.error();
    REQUIRE(std::chrono::steady_clock::now() < until);
  }
}

/// One server and a stream.
struct OneServer {
  explicit OneServer(const std::string& more = {}) : servers{{.servers = 1, .more = more}} {}
  NatsServers servers;
  StreamNames names = test_names();
};

}  // namespace talus::nats_test
