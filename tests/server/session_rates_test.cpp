// What rates do to a session.
#include <catch2/catch.hpp>

#include "session_bench.h"

using namespace talus;
using namespace talus::server;
using namespace std::chrono_literals;
using Body = wire::Body;

namespace {

RateLimits requests(Rate rate) {
  return {{{}, {}, rate}, {}};
}

/// So many chunks, all ready to be sent.
void want(SessionBench& bench, std::int32_t chunks) {
  for (std::int32_t x = 0; x < chunks; ++x) bench.get_chunk(static_cast<std::uint32_t>(x) + 1, chunk_at(x));
  bench.answer_all();
}

}  // namespace

TEST_CASE("a request over the rate is refused by its id, with the time after which it is granted") {
  SessionBench bench{{.rates = requests({10, 2})}};
  for (std::uint32_t id = 1; id <= 3; ++id) bench.get_chunk(id, chunk_at(0));
  const auto said = bench.output();
  REQUIRE(said.size() == 1);
  CHECK(said[0].code == wire::ErrorCode::overloaded);
  CHECK(said[0].id == 3);
  CHECK(said[0].retry_after_ms == 100);
  bench.clock.advance(100ms);
  bench.get_chunk(4, chunk_at(0));
  CHECK(bench.output().empty());
}

TEST_CASE("a refused request is counted by its rate") {
  SessionBench bench{{.rates = requests({10, 1})}};
  bench.ping();
  bench.ping();
  CHECK(bench.metrics.throttled(RateKind::session_requests).total() == 1);
}

TEST_CASE("Pings over the rate are refused without id") {
  SessionBench bench{{.rates = requests({10, 1})}};
  bench.ping();
  bench.ping();
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Pong, Body::Error});
  CHECK(said[1].code == wire::ErrorCode::overloaded);
  CHECK(said[1].id == 0);
}

TEST_CASE("a View over the rate is refused without id") {
  SessionBench bench{{.rates = requests({10, 1})}};
  bench.ping();
  bench.say_view(0, 1);
  CHECK_FALSE(bench.session.view_waits());
  CHECK(bench.output().back().code == wire::ErrorCode::overloaded);
}

TEST_CASE("an abusive client is told so and closed") {
  SessionBench bench{{.rates = requests({10, 20})}};
  for (int ask = 0; ask < 40; ++ask) bench.ping();
  CHECK(bench.session.state() == Session::State::joined);
  bench.ping();
  CHECK(bench.session.state() == Session::State::closed);
  const auto said = bench.output();
  CHECK(said.back().code == wire::ErrorCode::overloaded);
  CHECK(said.back().retry_after_ms > 0);
  CHECK_THAT(bench.session.failure(), Catch::Contains("abusive"));
}

TEST_CASE("chunks over the rate wait, and go when one is granted") {
  SessionBench bench{{.rates = {{{10, 3}, {}, {}}, {}}}};
  want(bench, 5);
  CHECK(bench.output().size() == 3);
  CHECK(bench.session.sendable_at() == bench.clock.now() + 100ms);
  CHECK(bench.output().empty());
  bench.clock.advance(100ms);
  CHECK(bench.session.sendable_at() <= bench.clock.now());
  CHECK(bench.output().size() == 1);
}

TEST_CASE("chunks wait for the bytes that went before them") {
  SessionBench bench{{.rates = {{{}, {1000, 1000}, {}}, {}}}};
  bench.source.payload_bytes = 2000;
  want(bench, 2);
  CHECK(bench.output().size() == 1);
  const auto wait = bench.session.sendable_at() - bench.clock.now();
  CHECK(wait > 1s);
  bench.clock.advance(wait);
  CHECK(bench.output().size() == 1);
}

TEST_CASE("rates of chunks and bytes do not delay a Pong") {
  SessionBench bench{{.rates = {{{1, 1}, {1, 1000}, {}}, {}}}};
  want(bench, 3);
  (void)bench.output();
  bench.ping();
  CHECK(bench.session.sendable_at() <= bench.clock.now());
  CHECK(kinds(bench.output()) == Kinds{Body::Pong});
}

TEST_CASE("a burst smaller than a frame keeps nobody from asking") {
  SessionBench bench{{.rates = {{{}, {1000, 10}, {}}, {}}}};
  for (int ask = 0; ask < 10; ++ask) {
    bench.ping();
    CHECK(kinds(bench.output()) == Kinds{Body::Pong});
  }
}

TEST_CASE("sessions of one address share its rates") {
  const SessionBench::Options options{.rates = {{}, {{10, 3}, {}, {}}},
                                      .address = std::make_shared<AddressBuckets>()};
  SessionBench one{options};
  SessionBench other{options};
  want(one, 2);
  want(other, 2);
  CHECK(one.output().size() == 2);
  CHECK(other.output().size() == 1);
  CHECK(other.session.sendable_at() > other.clock.now());
  CHECK(other.metrics.throttled(RateKind::address_chunks).total() == 1);
}
