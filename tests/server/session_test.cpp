// What the wire cannot show for certain: which answers a session waits for, and what it lets go.
#include "session/session.h"

#include <catch2/catch.hpp>

#include <talus/voxel/codec.h>

#include "fake_generator.h"

using namespace talus;
using namespace talus::server;

namespace {

/// A greeted session on a fake service; answers are carried over by hand.
struct Bench {
  FakeService fake;
  Limits limits;
  WorldInfo world;
  std::shared_ptr<WaitingClient> client = std::make_shared<WaitingClient>();
  Session session{{limits, world, fake.service, fake.metrics}};

  explicit Bench(std::size_t queue_chunks = 1000) : fake{1, queue_chunks} {
    session.attach(client);
    session.receive(protocol::make_frame([](auto& builder) {
      const auto codecs = builder.CreateVector(std::vector{kCodecVersion});
      return wire::CreateHello(builder, 1, 1, codecs);
    }));
    (void)session.take_output(1 << 20);
  }

  void get_chunk(std::uint32_t id, std::int32_t x) {
    session.receive(protocol::make_frame([&](auto& builder) {
      const std::vector<wire::ChunkRequest> requests{{id, {x, 0, 0, 0}, false, {}}};
      return wire::CreateGetChunks(builder, builder.CreateVectorOfStructs(requests));
    }));
    session.pump();
  }
  void cancel(std::uint32_t id) {
    session.receive(protocol::make_frame([&](auto& builder) {
      return wire::CreateCancel(builder, builder.CreateVector(std::vector<std::uint32_t>{id}));
    }));
    session.pump();
  }
  void look_at(std::int64_t chunk_x, std::uint16_t radius) {
    session.receive(protocol::make_frame([&](auto& builder) {
      const wire::Voxel centre{chunk_x * kChunkSize, 0, 0};
      const wire::Direction none{0, 0, 0};
      return wire::CreateView(builder, &centre, &none, radius, 0);
    }));
    session.apply_view();
    session.pump();
  }
  void carry_over() {
    for (const auto& [key, answer] : client->answers()) session.chunk_ready(key, answer);
  }
  [[nodiscard]] std::vector<wire::Body> output() {
    std::vector<wire::Body> kinds;
    for (const auto& frame : session.take_output(1 << 20)) {
      kinds.push_back((*protocol::read_message(frame))->body_type());
    }
    return kinds;
  }
};

using Kinds = std::vector<wire::Body>;

}  // namespace

TEST_CASE("two requests for one chunk are one job and two answers") {
  Bench bench;
  bench.get_chunk(1, 5);
  bench.get_chunk(2, 5);
  bench.client->await(1);
  bench.carry_over();
  CHECK(bench.fake.work->chunks == 1);
  CHECK(bench.output() == Kinds{wire::Body::Chunk, wire::Body::Chunk});
}

TEST_CASE("an answer that a Cancel missed is not sent") {
  Bench bench;
  bench.get_chunk(1, 5);
  bench.client->await(1);
  bench.cancel(1);
  bench.carry_over();
  CHECK(bench.output() == Kinds{wire::Body::Error});
}

TEST_CASE("a chunk that waits for credit can still be cancelled") {
  Bench bench;
  bench.get_chunk(1, 5);
  bench.client->await(1);
  bench.carry_over();
  bench.cancel(1);
  CHECK(bench.output() == Kinds{wire::Body::Error});
}

TEST_CASE("chunks that left the View are dropped before they are sent") {
  Bench bench;
  bench.look_at(0, 1);
  bench.client->await(9);
  bench.carry_over();
  bench.look_at(100, 0);
  bench.client->await(10);
  bench.carry_over();
  CHECK(bench.output() == Kinds{wire::Body::Chunk});
}

TEST_CASE("a View has only a window of chunks under way") {
  Bench bench;
  bench.look_at(0, 20);
  bench.client->await(Session::kViewWindow);
  CHECK(bench.client->answers().size() == Session::kViewWindow);
}

TEST_CASE("a session that failed says so and nothing else") {
  Bench bench;
  bench.get_chunk(1, 5);
  bench.client->await(1);
  bench.session.receive(protocol::make_frame([](auto& builder) { return wire::CreatePong(builder, 1); }));
  bench.carry_over();
  bench.get_chunk(2, 6);
  CHECK(bench.session.closing());
  CHECK(bench.output() == Kinds{wire::Body::Error});
}

TEST_CASE("after GoAway a session closes when its last request is answered") {
  Bench bench;
  bench.get_chunk(1, 5);
  bench.session.go_away("ending", 1);
  CHECK_FALSE(bench.session.closing());
  bench.client->await(1);
  bench.carry_over();
  CHECK(bench.output() == Kinds{wire::Body::GoAway, wire::Body::Chunk});
  CHECK(bench.session.closing());
}

TEST_CASE("a full generator queue refuses a request by its id, with a time to retry after") {
  Bench bench{1};
  bench.fake.work->close_gate();
  bench.get_chunk(1, 5);
  bench.get_chunk(2, 6);
  const auto frames = bench.session.take_output(1 << 20);
  REQUIRE(frames.size() == 1);
  const auto* refusal = (*protocol::read_message(frames[0]))->body_as_Error();
  REQUIRE(refusal != nullptr);
  CHECK(refusal->code() == wire::ErrorCode::overloaded);
  CHECK(refusal->request_id() == 2);
  CHECK(refusal->retry_after_ms() > 0);
}

TEST_CASE("a full generator queue delays a View, and says nothing of it") {
  Bench bench{1};
  bench.fake.work->close_gate();
  bench.look_at(0, 1);
  CHECK(bench.session.refused());
  bench.fake.work->open_gate();
  Kinds sent;
  for (std::size_t chunks = 1; chunks <= 9; ++chunks) {
    bench.client->await(chunks);
    bench.carry_over();
    for (const wire::Body kind : bench.output()) sent.push_back(kind);
    bench.session.pump();
  }
  CHECK(sent == Kinds(9, wire::Body::Chunk));
  CHECK_FALSE(bench.session.refused());
}

TEST_CASE("chunks that are being made count against what may wait for the client") {
  constexpr std::size_t kFit = 16;
  Bench bench{kFit};  // one more than fit would be refused
  bench.limits.queued_bytes_per_session = kFit * Session::kExpectedChunkBytes;
  bench.fake.work->close_gate();
  for (std::uint32_t id = 1; id <= 100; ++id) bench.get_chunk(id, static_cast<std::int32_t>(id));
  CHECK(bench.output().empty());
}

TEST_CASE("chunks that are being made count as much as the largest that came") {
  Bench bench{5};
  bench.limits.queued_bytes_per_session = 64 * 1024;
  bench.fake.work->payload_bytes = 15 * 1024;
  bench.get_chunk(1, 1);
  bench.client->await(1);
  bench.carry_over();
  (void)bench.output();
  bench.fake.work->close_gate();
  for (std::uint32_t id = 2; id <= 100; ++id) bench.get_chunk(id, static_cast<std::int32_t>(id));
  CHECK(bench.output().empty());
}
