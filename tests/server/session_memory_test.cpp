// What a session does near the memory budget, and what it tells it.
#include <catch2/catch.hpp>

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

/// A service on a fake generator with a budget, and a greeted session.
struct Bench {
  FakeService fake{1, 1000, kBudget};
  Limits limits;
  WorldInfo world;
  std::shared_ptr<WaitingClient> client = std::make_shared<WaitingClient>();
  AccessControl access{Access{}, *load_keys(Access{})};
  Session session{{limits, world, fake.service, fake.memory, fake.metrics, access}};

  Bench() {
    session.attach(client->mailbox());
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

TEST_CASE("near the budget what needs a generator is refused, and what is at hand is not") {
  Bench bench;
  bench.get_chunk(1, 1);
  bench.client->await(1);
  for (const auto& [key, answer] : bench.client->answers()) bench.session.chunk_ready(key, answer);
  (void)bench.session.take_output(1 << 20);
  bench.fake.memory.set(MemoryUse::generators, kBudget / 4 * 3);
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
  bench.fake.memory.set(MemoryUse::generators, kBudget / 4 * 3);
  bench.look_around();
  CHECK(bench.session.refused());
  CHECK(bench.fake.service.status().jobs == 0);
  bench.fake.memory.set(MemoryUse::generators, 0);
  bench.session.pump();
  bench.client->await(9);
  CHECK_FALSE(bench.session.refused());
}

TEST_CASE("a session tells what it holds, and gives it back") {
  Bench bench;
  const std::uint64_t idle = bench.fake.memory.used(MemoryUse::sessions);
  CHECK(idle >= Session::kIdleBytes);
  bench.fake.work->payload_bytes = 100'000;
  bench.get_chunk(1, 1);
  bench.client->await(1);
  for (const auto& [key, answer] : bench.client->answers()) bench.session.chunk_ready(key, answer);
  bench.session.pump();
  CHECK(bench.fake.memory.used(MemoryUse::sessions) >= Session::kIdleBytes + 100'000);
  (void)bench.session.take_output(1 << 20);
  bench.session.written();
  bench.session.pump();
  CHECK(bench.fake.memory.used(MemoryUse::sessions) < idle + 10'000);
}
