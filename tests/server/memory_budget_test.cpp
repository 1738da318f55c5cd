#include "memory/memory_budget.h"

#include <catch2/catch.hpp>
#include <thread>
#include <vector>

#include <rapidcheck.h>

#include <talus/voxel/codec.h>

#include "access/access_control.h"
#include "fake_generator.h"
#include "frames.h"
#include "session/session.h"

using namespace talus;
using namespace talus::server;

namespace {

constexpr std::uint64_t kMebibyte = 1U << 20;
constexpr std::uint64_t kBudget = 800 * kMebibyte;

/// So much beside the caches, the program's share included.
void hold(MemoryBudget& budget, std::uint64_t bytes) {
  budget.set(MemoryUse::sessions, bytes - MemoryBudget::kProgramBytes);
}

/// A service on a fake generator with a budget, and a greeted session.
struct Bench {
  std::shared_ptr<FakeWork> work = std::make_shared<FakeWork>();
  Metrics metrics;
  MemoryBudget budget{kBudget};
  ChunkService service{std::make_unique<FakeGenerator>(work),
                       {1, 4, 1000, 64 * kMebibyte, 64 * kMebibyte},
                       std::make_shared<spdlog::logger>("silent"),
                       metrics,
                       budget};
  Limits limits;
  WorldInfo world;
  std::shared_ptr<WaitingClient> client = std::make_shared<WaitingClient>();
  AccessControl access{Access{}, *load_keys(Access{})};
  Session session{{limits, world, service, metrics, access}};

  Bench() {
    service.start();
    session.attach(client);
    receive([](auto& builder) {
      const auto codecs = builder.CreateVector(std::vector{kCodecVersion});
      return wire::CreateHello(builder, 1, 1, codecs);
    });
    (void)session.take_output(1 << 20);
  }
  template <typename Make>
  void receive(Make&& make) {
    session.receive(protocol::make_frame(make));
    session.pump();
  }
  void get_chunk(std::uint32_t id, std::int32_t x) {
    receive([&](auto& builder) {
      const std::vector<wire::ChunkRequest> requests{{id, {x, 0, 0, 0}, false, {}}};
      return wire::CreateGetChunks(builder, builder.CreateVectorOfStructs(requests));
    });
  }
  void get_heights(std::uint32_t id) {
    receive([&](auto& builder) {
      return wire::CreateGetHeights(builder, id,
                                    builder.CreateVectorOfStructs(std::vector{wire::Column2{0, 0}}));
    });
  }
  void look_around() {
    receive([](auto& builder) {
      const wire::Voxel centre{};
      return wire::CreateView(builder, &centre, nullptr, 1, 0);
    });
    session.apply_view();
    session.pump();
  }
};

void check_refused(const protocol::Frame& frame, std::uint32_t id) {
  const auto* error = (*protocol::read_message(frame))->body_as_Error();
  REQUIRE(error != nullptr);
  CHECK(error->code() == wire::ErrorCode::overloaded);
  CHECK(error->request_id() == id);
  CHECK(error->retry_after_ms() > 0);
}

}  // namespace

TEST_CASE("without a budget nothing is refused") {
  MemoryBudget budget{0};
  budget.set(MemoryUse::sessions, UINT64_MAX / 4);
  CHECK(budget.takes_work());
  CHECK(budget.takes_connections());
  CHECK(budget.for_caches(kBudget) == kBudget);
}

TEST_CASE("caches give way before anything is refused") {
  MemoryBudget budget{kBudget};
  budget.set(MemoryUse::chunk_cache, kBudget);
  hold(budget, 450 * kMebibyte);
  CHECK(budget.takes_work());
  CHECK(budget.takes_connections());
  CHECK(budget.for_caches(kBudget) == 250 * kMebibyte);
}

TEST_CASE("connections are refused before work is, and neither flaps") {
  MemoryBudget budget{kBudget};
  hold(budget, 500 * kMebibyte);
  CHECK_FALSE(budget.takes_connections());
  CHECK(budget.takes_work());
  hold(budget, 600 * kMebibyte);
  CHECK_FALSE(budget.takes_work());
  hold(budget, 550 * kMebibyte);
  CHECK_FALSE(budget.takes_work());
  hold(budget, 499 * kMebibyte);
  CHECK(budget.takes_work());
  CHECK_FALSE(budget.takes_connections());
  hold(budget, 399 * kMebibyte);
  CHECK(budget.takes_connections());
}

TEST_CASE("while work is taken, it and the caches together are below the budget") {
  CHECK(rc::check([] {
    MemoryBudget budget{*rc::gen::inRange<std::uint64_t>(64 * kMebibyte, 1024 * 1024 * kMebibyte)};
    const auto beside = *rc::gen::inRange<std::uint64_t>(MemoryBudget::kProgramBytes, budget.limit_bytes());
    hold(budget, beside);
    if (!budget.takes_work()) return;
    RC_ASSERT(beside + budget.for_caches(UINT64_MAX) <= budget.limit_bytes() / 8 * 7 + 7);
  }));
}

TEST_CASE("what a holder told is given back with it, whatever other threads do") {
  MemoryBudget budget{kBudget};
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 4; ++thread) {
    threads.emplace_back([&] {
      for (std::uint64_t i = 0; i < 1000; ++i) {
        MemoryShare share{budget, MemoryUse::sessions};
        share.hold(i * 5000);
        share.hold(i * 100);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(budget.used(MemoryUse::sessions) == 0);
}

TEST_CASE("near the budget what needs a generator is refused, and what is at hand is not") {
  Bench bench;
  bench.get_chunk(1, 1);
  bench.client->await(1);
  for (const auto& [key, answer] : bench.client->answers()) bench.session.chunk_ready(key, answer);
  (void)bench.session.take_output(1 << 20);
  bench.budget.set(MemoryUse::generators, kBudget / 4 * 3);
  bench.get_chunk(2, 2);
  bench.get_heights(3);
  bench.get_chunk(4, 1);
  const auto said = cut(bench.session.take_output(1 << 20));
  REQUIRE(said.size() == 3);
  check_refused(said[0], 2);
  check_refused(said[1], 3);
  CHECK((*protocol::read_message(said[2]))->body_type() == wire::Body::Chunk);
}

TEST_CASE("near the budget a View waits, and goes on when there is room again") {
  Bench bench;
  bench.budget.set(MemoryUse::generators, kBudget / 4 * 3);
  bench.look_around();
  CHECK(bench.session.refused());
  CHECK(bench.service.status().jobs == 0);
  bench.budget.set(MemoryUse::generators, 0);
  bench.session.pump();
  bench.client->await(9);
  CHECK_FALSE(bench.session.refused());
}

TEST_CASE("caches shrink as soon as everything else grows, and grow again") {
  Bench bench;
  bench.work->payload_bytes = 1000;
  for (std::int32_t x = 0; x < 1000; ++x)
    REQUIRE(bench.service.submit(bench.client, {{x, 0, 0}, Lod{}}) == ChunkService::Submission::queued);
  bench.client->await(1000);
  CHECK(bench.service.status().chunk_cache_bytes > 1'000'000);
  bench.budget.set(MemoryUse::sessions, UINT64_MAX / 4);
  bench.service.fit_caches();
  const std::uint64_t held =
      bench.budget.used(MemoryUse::chunk_cache) + bench.budget.used(MemoryUse::patch_cache);
  CHECK(held <= kBudget / 16);
  CHECK(bench.budget.for_caches(UINT64_MAX) == kBudget / 16);
}

TEST_CASE("a session tells what it holds, and gives it back") {
  Bench bench;
  const std::uint64_t idle = bench.budget.used(MemoryUse::sessions);
  CHECK(idle >= Session::kIdleBytes);
  bench.work->payload_bytes = 100'000;
  bench.get_chunk(1, 1);
  bench.client->await(1);
  for (const auto& [key, answer] : bench.client->answers()) bench.session.chunk_ready(key, answer);
  bench.session.pump();
  CHECK(bench.budget.used(MemoryUse::sessions) >= Session::kIdleBytes + 100'000);
  (void)bench.session.take_output(1 << 20);
  bench.session.written();
  bench.session.pump();
  CHECK(bench.budget.used(MemoryUse::sessions) < idle + 10'000);
}

TEST_CASE("generators are reckoned with an eighth of the budget at most, so that somebody can come") {
  const auto work = std::make_shared<FakeWork>();
  work->patch_columns = 4'000'000;
  Metrics metrics;
  MemoryBudget budget{128 * kMebibyte};
  ChunkService service{std::make_unique<FakeGenerator>(work),
                       {2, 4, 1000, kMebibyte, kMebibyte},
                       std::make_shared<spdlog::logger>("silent"),
                       metrics,
                       budget};
  service.start();
  const auto client = std::make_shared<WaitingClient>();
  REQUIRE(service.submit(client, {{1, 2, 3}, Lod{}}) == ChunkService::Submission::queued);
  client->await(1);
  CHECK(budget.used(MemoryUse::generators) == 16 * kMebibyte);
  CHECK(budget.takes_connections());
  CHECK(budget.takes_work());
}
