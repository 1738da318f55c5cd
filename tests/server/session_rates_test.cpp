// What rates do to a session.
#include <algorithm>
#include <catch2/catch.hpp>
#include <deque>
#include <map>
#include <utility>
#include <vector>

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

TEST_CASE("a client with a thousand requests in flight that waits for the given times is never closed") {
  const bool for_the_last = GENERATE(true, false);  // or each request as its own Error says
  SessionBench bench{{.rates = requests({50, 60})}};
  using Due = std::multimap<Clock::time_point, std::uint32_t>;
  Due due;
  for (std::uint32_t id = 1; id <= 1000; ++id) due.emplace(bench.clock.now(), id);
  std::size_t answered = 0;
  std::size_t sent = 0;
  while (!due.empty()) {
    const auto now = std::max(bench.clock.now(), due.begin()->first);
    bench.clock.advance(now - bench.clock.now());
    std::vector<std::pair<std::uint32_t, ChunkKey>> wanted;
    for (; !due.empty() && due.begin()->first <= now; due.erase(due.begin())) {
      const std::uint32_t id = due.begin()->second;
      wanted.emplace_back(id, chunk_at(static_cast<std::int32_t>(id)));
    }
    sent += wanted.size();
    bench.get_chunks(wanted);
    bench.answer_all();
    Clock::time_point all_due = now;
    std::vector<std::uint32_t> refused;
    for (const SessionFrame& each : bench.run_dry()) {
      if (each.kind == Body::Chunk) {
        ++answered;
        continue;
      }
      REQUIRE(each.code == wire::ErrorCode::overloaded);
      REQUIRE(each.about == wire::ErrorAbout::request);
      all_due = std::max(all_due, now + std::chrono::milliseconds{each.retry_after_ms});
      if (for_the_last) refused.push_back(each.id);
      if (!for_the_last) due.emplace(now + std::chrono::milliseconds{each.retry_after_ms}, each.id);
    }
    for (const std::uint32_t id : refused) due.emplace(all_due, id);
    REQUIRE(bench.session.state() == Session::State::joined);
  }
  CHECK(answered == 1000);
  if (!for_the_last) CHECK(sent == 1000 + 940);  // each that was refused came once more
}

TEST_CASE("a request over the rate whose id is in use is refused as what it is") {
  SessionBench bench{{.rates = requests({10, 1})}};
  bench.get_chunk(1, chunk_at(0));
  bench.get_chunk(1, chunk_at(0));
  const auto said = bench.output();
  REQUIRE(said.size() == 1);
  CHECK(said[0].code == wire::ErrorCode::overloaded);
  CHECK(said[0].about == wire::ErrorAbout::repeated_request);
  CHECK(said[0].repeated_id == 1);
  CHECK(said[0].id == 0);
}

TEST_CASE("Welcome has the rates of the session and of its address, if they apply") {
  const bool has_address = GENERATE(true, false);
  SessionBench bench{
      {.rates = {{{10, 20}, {30, 60}, {50, 100}}, {}, 2000ms},
       .address = has_address ? std::make_shared<AddressBuckets>(RateSet{{70, 140}, {}, {90, 180}}) : nullptr,
       .greet = false}};
  bench.hello();
  const auto frames = cut(bench.session.take_output(1 << 20));
  const auto* limits = (*protocol::read_message(frames.at(0)))->body_as_Welcome()->limits();
  CHECK(limits->session_rates()->chunks() == 10);
  CHECK(limits->session_rates()->bytes() == 30);
  CHECK(limits->session_rates()->requests() == 50);
  CHECK(limits->session_rates()->burst_ms() == 2000);
  CHECK(limits->address_rates()->chunks() == (has_address ? 70 : 0));
  CHECK(limits->address_rates()->bytes() == 0);
  CHECK(limits->address_rates()->requests() == (has_address ? 90 : 0));
}

TEST_CASE("refusals as too fast or too many count for the flow, and no other Error") {
  SessionBench bench{{.rates = requests({10, 4})}};
  bench.get_chunk(1, chunk_at(0));
  bench.get_chunk(1, chunk_at(0));  // duplicate_id
  bench.edit(2);                    // unsupported
  CHECK(bench.session.flow().used(FlowMeasure::refusals) == 0);
  for (int i = 0; i < 3; ++i) bench.ping();
  CHECK(bench.session.flow().used(FlowMeasure::refusals) == 2);
}

TEST_CASE("rates that change count for a session that is there, and it keeps what it owes") {
  SessionBench bench{{.rates = requests({10, 4})}};
  const auto pongs = [&] {
    for (int i = 0; i < 10; ++i) bench.ping();
    const auto said = kinds(bench.output());
    return std::count(said.begin(), said.end(), Body::Pong);
  };
  bench.ping();
  bench.ping();
  (void)bench.output();
  bench.rates.set(requests({1, 8}));  // two tokens are left
  bench.session.rates_changed(nullptr);
  CHECK(pongs() == 2);
  bench.clock.advance(3s);
  CHECK(pongs() == 3);
  bench.rates.set(requests({}));
  bench.session.rates_changed(nullptr);
  CHECK(pongs() == 10);
}

TEST_CASE("Pings over the rate are refused without id") {
  SessionBench bench{{.rates = requests({10, 1})}};
  bench.ping();
  bench.ping();
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Pong, Body::Error});
  CHECK(said[1].code == wire::ErrorCode::overloaded);
  CHECK(said[1].id == 0);
  CHECK(said[1].about == wire::ErrorAbout::ping);
}

TEST_CASE("a View over the rate is refused without id") {
  SessionBench bench{{.rates = requests({10, 1})}};
  bench.ping();
  bench.view_number = 6;
  bench.say_view(0, 1);
  CHECK_FALSE(bench.session.view_waits());
  const auto said = bench.output();
  CHECK(said.back().code == wire::ErrorCode::overloaded);
  CHECK(said.back().about == wire::ErrorAbout::view);
  CHECK(said.back().view_number == 6);
}

TEST_CASE("an abusive client gets the reason and is closed") {
  SessionBench bench{{.rates = requests({10, 20})}};
  // Its burst, what it may have in flight, and what goes in a second without an answer.
  const std::uint32_t patience = 20 + bench.limits.requests_in_flight + 10;
  for (std::uint32_t ask = 0; ask < patience; ++ask) bench.ping();
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

TEST_CASE("a burst smaller than a frame blocks no client") {
  SessionBench bench{{.rates = {{{}, {1000, 10}, {}}, {}}}};
  for (int ask = 0; ask < 10; ++ask) {
    bench.ping();
    CHECK(kinds(bench.output()) == Kinds{Body::Pong});
  }
}

TEST_CASE("a session that ends gives back what it has reserved of its address's rates") {
  const RateSet of_address{{1000, 100}, {}, {}};
  const auto address = std::make_shared<AddressBuckets>(of_address);
  SessionBench bench{{.rates = {{}, of_address, {}}, .address = address}};
  address->chunks = [&] {
    TokenBucket bucket;
    bucket.spend(of_address.chunks, bench.clock.now(), 100);
    return bucket;
  }();
  bench.get_chunk(1, chunk_at(5));
  bench.answer_all();
  CHECK(bench.session.sendable_at() > bench.clock.now());
  const auto level = [&] { return address->chunks.load().level(of_address.chunks, bench.clock.now()); };
  CHECK(level() == -10);
  bench.session.abandon();
  CHECK(level() == 0);
}

TEST_CASE("sessions of one address share its rates") {
  const SessionBench::Options options{.address = std::make_shared<AddressBuckets>(RateSet{{10, 3}, {}, {}})};
  SessionBench one{options};
  SessionBench other{options};
  want(one, 2);
  want(other, 2);
  CHECK(one.output().size() == 2);
  CHECK(other.output().size() == 1);
  CHECK(other.session.sendable_at() > other.clock.now());
  CHECK(other.metrics.throttled(RateKind::address_chunks).total() == 1);
}

TEST_CASE("players of an address that has used up its rate wait for that alone, and not for long") {
  // Each flies at 20 voxels/s over 73 new chunks in a second, and all have half of that.
  constexpr std::size_t kPlayers = 4;
  constexpr std::size_t kTicksAChunk = 32;
  constexpr auto kTick = 50ms;
  constexpr std::size_t kTicks = 400;
  constexpr std::size_t kPerSecond = kPlayers * 73 / 2;
  const auto address = std::make_shared<AddressBuckets>(RateSet{{kPerSecond, kPerSecond}, {}, {}});
  struct Player {
    explicit Player(const AddressBucketsPtr& buckets) : bench{{.address = buckets}} {}
    SessionBench bench;
    Clock::duration without{};
    Clock::duration longest_without{};
  };
  std::deque<Player> players;
  for (std::size_t i = 0; i < kPlayers; ++i) players.emplace_back(address);
  std::size_t chunks = 0;
  for (std::size_t tick = 0; tick < kTicks; ++tick) {
    for (std::size_t i = 0; i < kPlayers; ++i) {
      Player& player = players[(tick + i) % kPlayers];
      SessionBench& bench = player.bench;
      const std::size_t x = tick / kTicksAChunk;
      if (tick % kTicksAChunk == 0) bench.move_view(static_cast<std::int64_t>(x), 6, 4);
      bench.answer_all();  // the generators have nothing to do
      player.without += kTick;
      if (bench.session.sendable_at() <= bench.clock.now()) {
        for (const SessionFrame& said : bench.output()) {
          if (said.kind != Body::Chunk) continue;
          player.without = {};
          ++chunks;
        }
      }
      player.longest_without = std::max(player.longest_without, player.without);
      bench.clock.advance(kTick);
    }
  }
  CHECK(static_cast<double>(chunks) == Approx(kPerSecond * (kTicks / 20 + 1)).epsilon(0.1));
  std::uint64_t held = 0;
  for (Player& player : players) {
    CHECK(player.longest_without <= 1s);
    held += player.bench.metrics.throttled(RateKind::address_chunks).total();
  }
  CHECK(held > 0);
}
