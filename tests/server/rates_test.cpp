// What rates do to a session, by a clock that the test sets.
#include "rates/rates.h"

#include <catch2/catch.hpp>

#include <talus/voxel/codec.h>

#include "access/access_control.h"
#include "fake_generator.h"
#include "frames.h"
#include "session/session.h"

using namespace talus;
using namespace talus::server;
using namespace std::chrono_literals;

namespace {

constexpr Session::Clock::time_point kStart{1000s};

struct Said {
  wire::Body kind{};
  wire::ErrorCode code{};
  std::uint32_t id = 0;
  std::uint32_t retry_after_ms = 0;
};

/// A greeted session; answers are carried over by hand, and time passes when the test says.
struct Bench {
  FakeService fake;
  Limits limits;
  WorldInfo world;
  RateLimits rates;
  std::shared_ptr<WaitingClient> client = std::make_shared<WaitingClient>();
  Session::Clock::time_point now = kStart;
  AccessControl access{Access{}, *load_keys(Access{})};
  Session session;

  explicit Bench(const RateLimits& some, const AddressBucketsPtr& address = nullptr)
      : rates{some},
        session{{limits, world, fake.service, fake.memory, fake.metrics, access, rates}, address} {
    session.attach(client->mailbox());
    receive([](auto& builder) {
      const auto codecs = builder.CreateVector(std::vector{kCodecVersion});
      return wire::CreateHello(builder, 1, 1, codecs);
    });
    (void)output();
  }

  template <typename Make>
  void receive(Make&& make) {
    session.receive(protocol::make_frame(make), now);
    session.pump();
  }
  void get_chunk(std::uint32_t id, std::int32_t x = 0) {
    receive([&](auto& builder) {
      const std::vector<wire::ChunkRequest> requests{{id, {x, 0, 0, 0}, false, {}}};
      return wire::CreateGetChunks(builder, builder.CreateVectorOfStructs(requests));
    });
  }
  void ping() {
    receive([](auto& builder) { return wire::CreatePing(builder, 7); });
  }
  /// A row of so many chunks, all ready to be sent.
  void want(std::int32_t chunks) {
    for (std::int32_t x = 0; x < chunks; ++x) get_chunk(static_cast<std::uint32_t>(x) + 1, x);
    client->await(static_cast<std::size_t>(chunks));
    for (const auto& [key, answer] : client->answers()) session.chunk_ready(key, answer);
  }
  [[nodiscard]] std::vector<Said> output() {
    std::vector<Said> said;
    for (const auto& frame : cut(session.take_output(1 << 20, now))) {
      const wire::Message& message = **protocol::read_message(frame);
      Said& each = said.emplace_back(Said{message.body_type()});
      if (const auto* error = message.body_as_Error()) {
        each.code = error->code();
        each.id = error->request_id();
        each.retry_after_ms = error->retry_after_ms();
      }
    }
    return said;
  }
  [[nodiscard]] std::uint64_t held(RateKind kind) { return fake.metrics.throttled(kind).total(); }
};

RateLimits requests(Rate rate) {
  return {{{}, {}, rate}, {}};
}

}  // namespace

TEST_CASE("a request over the rate is refused by its id, with the time after which there is room") {
  Bench bench{requests({10, 2})};
  bench.fake.work->close_gate();  // or the chunk may be at hand for the last request
  for (std::uint32_t id = 1; id <= 3; ++id) bench.get_chunk(id);
  const auto said = bench.output();
  REQUIRE(said.size() == 1);
  CHECK(said[0].code == wire::ErrorCode::overloaded);
  CHECK(said[0].id == 3);
  CHECK(said[0].retry_after_ms == 100);
  CHECK(bench.held(RateKind::session_requests) == 1);

  bench.now += 99ms;
  bench.get_chunk(4);
  CHECK(bench.output().size() == 1);
  bench.now += 1ms;
  bench.get_chunk(5);
  CHECK(bench.output().empty());
}

TEST_CASE("Pings and Views count as requests, and have no id") {
  Bench bench{requests({10, 1})};
  bench.ping();
  CHECK(bench.output().at(0).kind == wire::Body::Pong);
  bench.ping();
  bench.receive([](auto& builder) {
    const wire::Voxel centre{};
    return wire::CreateView(builder, &centre, nullptr, 1, 1);
  });
  const auto said = bench.output();
  REQUIRE(said.size() == 2);
  for (const Said& each : said) {
    CHECK(each.code == wire::ErrorCode::overloaded);
    CHECK(each.id == 0);
  }
  CHECK_FALSE(bench.session.view_waits());
}

TEST_CASE("who is refused as often as it may ask, and asks on, is told and closed") {
  Bench bench{requests({10, 20})};
  for (std::uint32_t ask = 0; ask < 40; ++ask) bench.ping();
  CHECK_FALSE(bench.session.closing());
  bench.ping();
  CHECK(bench.session.closing());
  const auto said = bench.output();
  CHECK(said.back().code == wire::ErrorCode::overloaded);
  CHECK(said.back().retry_after_ms > 0);
  CHECK_THAT(bench.session.failure(), Catch::Contains("flooding"));
}

TEST_CASE("who keeps to the times that refusals name is never closed") {
  Bench bench{requests({10, 2})};
  for (int ask = 0; ask < 1000; ++ask) {
    bench.ping();
    for (const Said& each : bench.output()) bench.now += std::chrono::milliseconds{each.retry_after_ms};
  }
  CHECK_FALSE(bench.session.closing());
}

TEST_CASE("chunks over the rate wait, and go when there is room for one") {
  Bench bench{{{{10, 3}, {}, {}}, {}}};
  bench.want(5);
  CHECK(bench.output().size() == 3);
  CHECK(bench.session.sendable_at(bench.now) == bench.now + 100ms);
  CHECK(bench.output().empty());
  bench.now += 100ms;
  CHECK(bench.session.sendable_at(bench.now) <= bench.now);
  CHECK(bench.output().size() == 1);
  CHECK(bench.held(RateKind::session_chunks) == 1);
}

TEST_CASE("chunks wait for the bytes that went before them") {
  Bench bench{{{{}, {1000, 1000}, {}}, {}}};
  bench.fake.work->payload_bytes = 2000;
  bench.want(2);
  CHECK(bench.output().size() == 1);
  const auto due = bench.session.sendable_at(bench.now);
  CHECK(due > bench.now + 1s);
  bench.now = due;
  CHECK(bench.output().size() == 1);
}

TEST_CASE("a Pong is not held by rates of chunks and bytes") {
  Bench bench{{{{1, 1}, {1, 1000}, {}}, {}}};
  bench.want(3);
  (void)bench.output();
  bench.ping();
  CHECK(bench.session.sendable_at(bench.now) <= bench.now);
  const auto said = bench.output();
  REQUIRE(said.size() == 1);
  CHECK(said[0].kind == wire::Body::Pong);
}

TEST_CASE("a burst smaller than a frame does not keep anybody from asking") {
  Bench bench{{{{}, {1000, 10}, {}}, {}}};
  for (int ask = 0; ask < 10; ++ask) {
    bench.ping();
    CHECK(bench.output().at(0).kind == wire::Body::Pong);
  }
}

TEST_CASE("who is far over its bytes by answers that no rate holds may not ask more") {
  Bench bench{{{{}, {1000, 1000}, {}}, {}}};
  int pongs = 0;
  for (bool refused = false; !refused;) {
    bench.ping();
    refused = bench.output().at(0).kind == wire::Body::Error;
    REQUIRE(++pongs < 1000);
  }
  CHECK(bench.held(RateKind::session_bytes) == 1);
}

TEST_CASE("sessions of one address share its rates") {
  const RateLimits limits{{}, {{10, 3}, {}, {10, 4}}};
  const auto address = std::make_shared<AddressBuckets>();
  Bench one{limits, address};
  Bench other{limits, address};
  one.want(2);
  other.want(2);
  CHECK(one.output().size() == 2);
  CHECK(other.output().size() == 1);
  CHECK(other.session.sendable_at(other.now) > other.now);
  one.ping();
  CHECK(one.output().at(0).code == wire::ErrorCode::overloaded);
  CHECK(one.held(RateKind::address_requests) == 1);
  CHECK(other.held(RateKind::address_chunks) == 1);
}

TEST_CASE("threads that share an address's bucket take no more than it has") {
  const RateLimits limits{{}, {{}, {}, {1, 20'000}}};
  const auto address = std::make_shared<AddressBuckets>();
  Metrics metrics;
  std::atomic<int> admitted{0};
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 4; ++thread) {
    threads.emplace_back([&] {
      SessionRates rates{limits, address, metrics};
      for (int ask = 0; ask < 10'000; ++ask) admitted += rates.refuse_request(kStart) ? 0 : 1;
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(admitted == 20'000);
}

TEST_CASE("a burst is what the rate earns in its time, and never nothing") {
  Rates config;
  config.session_chunks = 1000;
  config.session_requests = 1;
  config.address_bytes = 0;
  config.burst = std::chrono::milliseconds{500};
  const RateLimits limits = rate_limits(config);
  CHECK(limits.session.chunks == Rate{1000, 500});
  CHECK(limits.session.requests == Rate{1, 1});
  CHECK_FALSE(limits.address.bytes.limited());
}

TEST_CASE("the default burst holds the mixed chunks of a View of the largest radius") {
  const Config config;
  const std::uint64_t columns =
      (2 * config.limits.view_horizontal_radius + 1) * (2 * config.limits.view_horizontal_radius + 1);
  CHECK(rate_limits(config.rates).session.chunks.burst >= 3 * columns);
}
