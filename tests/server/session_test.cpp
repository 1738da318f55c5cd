// What the wire cannot show for certain: which answers a session waits for, and what it lets go.
#include "session/session.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <set>

#include <talus/voxel/codec.h>

#include "fake_generator.h"
#include "frames.h"

using namespace talus;
using namespace talus::server;

namespace {

/// A greeted session on a fake service; answers are carried over by hand.
struct Bench {
  FakeService fake;
  Limits limits;
  WorldInfo world;
  AccessControl access{Access{}, *load_keys(Access{})};
  std::shared_ptr<WaitingClient> client = std::make_shared<WaitingClient>();
  Session session{{limits, world, fake.service, fake.memory, fake.metrics, access}};

  explicit Bench(std::size_t queue_chunks = 1000) : fake{1, queue_chunks} {
    session.attach(client->mailbox());
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
  void look_at(std::int64_t chunk_x, std::uint16_t radius, std::uint16_t vertical_radius = 0,
               const std::vector<wire::KnownChunk>& known = {}) {
    say_view(chunk_x, radius, vertical_radius, known);
    session.apply_view();
    session.pump();
  }
  void say_view(std::int64_t chunk_x, std::uint16_t radius, std::uint16_t vertical_radius = 0,
                const std::vector<wire::KnownChunk>& known = {}) {
    session.receive(protocol::make_frame([&](auto& builder) {
      const wire::Voxel centre{chunk_x * kChunkSize, 0, 0};
      const wire::Direction none{0, 0, 0};
      const auto held = builder.CreateVectorOfStructs(known);
      return wire::CreateView(builder, &centre, &none, radius, vertical_radius, 0, held);
    }));
  }
  void carry_over() {
    for (const auto& [key, answer] : client->answers()) session.chunk_ready(key, answer);
  }
  [[nodiscard]] std::vector<protocol::Frame> frames(std::size_t enough_bytes = 1 << 20) {
    return cut(session.take_output(enough_bytes));
  }
  [[nodiscard]] std::vector<wire::Body> output() {
    std::vector<wire::Body> kinds;
    for (const auto& frame : frames()) {
      kinds.push_back((*protocol::read_message(frame))->body_type());
    }
    return kinds;
  }
};

using Kinds = std::vector<wire::Body>;
using Runs = std::vector<std::array<std::int32_t, 3>>;  // first row, last row, material

/// What the Columns of an output say, one after the other; other frames are passed over.
Runs runs_of(const std::vector<protocol::Frame>& frames) {
  Runs runs;
  for (const auto& frame : frames) {
    const wire::Message& message = **protocol::read_message(frame);
    if (message.body_type() != wire::Body::Column) continue;
    for (const wire::UniformRun* run : *message.body_as_Column()->runs()) {
      runs.push_back({run->first_y(), run->last_y(), run->material()});
    }
  }
  return runs;
}

}  // namespace

TEST_CASE("air that is known without looking comes as one Column, before anything is generated") {
  Bench bench;
  bench.fake.work->close_gate();
  bench.fake.work->last_mixed_anywhere = 0;
  bench.look_at(0, 0, 3);
  CHECK(runs_of(bench.frames()) == Runs{{1, 3, 0}});
  CHECK(bench.fake.service.status().jobs == 4);
}

TEST_CASE("what the terrain shows to be uniform comes in its column's one message, and is not made") {
  Bench bench;
  bench.fake.work->first_mixed = -1;
  bench.fake.work->last_mixed = 0;
  bench.fake.work->close_gate();
  bench.look_at(0, 0, 3);  // rows -3 to 3, all mixed for all that is known
  bench.fake.work->open_gate();
  bench.client->await(7);
  // The first answers are of uniform chunks: they tell of the whole column, also of those not answered yet.
  const auto answers = bench.client->answers();
  const auto above = std::find_if(answers.begin(), answers.end(),
                                  [](const auto& answer) { return answer.first.coord.y == 2; });
  bench.session.chunk_ready(above->first, above->second);
  CHECK(runs_of(bench.frames()) == Runs{{-3, -2, 2}, {1, 3, 0}});
  bench.carry_over();
  CHECK(bench.output() == Kinds{wire::Body::Chunk, wire::Body::Chunk});
}

TEST_CASE("a column that is known asks for no uniform chunk") {
  Bench bench;
  bench.fake.work->first_mixed = 0;
  bench.fake.work->last_mixed = 0;
  bench.get_chunk(1, 0);
  bench.client->await(1);
  bench.carry_over();
  (void)bench.output();
  const int made = bench.fake.work->chunks;
  bench.look_at(0, 0, 5);
  const auto frames = bench.frames();
  CHECK(runs_of(frames) == Runs{{-5, -1, 2}, {1, 5, 0}});
  CHECK(frames.size() == 2);  // and the mixed one, which is at hand
  CHECK(bench.fake.work->chunks == made);
}

TEST_CASE("what left in a View that nobody looked at is sent again") {
  Bench bench;
  bench.look_at(0, 0);
  bench.client->await(1);
  bench.carry_over();
  CHECK(bench.output() == Kinds{wire::Body::Chunk});
  const int away = GENERATE(0, 1, 5, 100);  // Views in between, of which the client forgot what it had
  for (int view = 1; view <= away; ++view) bench.say_view(view * 1000, 0);
  bench.look_at(0, 0);
  CHECK(bench.output() == (away == 0 ? Kinds{} : Kinds{wire::Body::Chunk}));
}

TEST_CASE("any number of Views of the same chunks between two looks has nothing sent again") {
  Bench bench;
  bench.look_at(0, 0);
  bench.client->await(1);
  bench.carry_over();
  CHECK(bench.output() == Kinds{wire::Body::Chunk});
  for (int view = 0; view < 100; ++view) bench.say_view(0, 0);
  bench.look_at(0, 0);
  CHECK(bench.output().empty());
}

TEST_CASE("what was under way when it left in a View that nobody looked at is still sent once") {
  Bench bench;
  bench.fake.work->close_gate();
  bench.look_at(0, 0);
  bench.say_view(1000, 0);
  bench.look_at(0, 0);
  bench.fake.work->open_gate();
  bench.client->await(1);
  bench.carry_over();
  CHECK(bench.output() == Kinds{wire::Body::Chunk});
}

TEST_CASE("a chunk that the client holds is confirmed instead of sent, where it is still the same") {
  Bench bench;
  const bool same = GENERATE(true, false);
  const wire::ChunkKey key{0, 0, 0, 0};
  const auto hash = std::hash<ChunkKey>{}(ChunkKey{{0, 0, 0}, Lod{}});
  bench.look_at(0, 0, 0, {wire::KnownChunk{key, wire::Hash128{hash, same ? 0U : 1U}}});
  bench.client->await(1);
  bench.carry_over();
  CHECK(bench.output() == Kinds{same ? wire::Body::Unchanged : wire::Body::Chunk});
  bench.look_at(0, 0);
  CHECK(bench.output().empty());
}

TEST_CASE("a walk to and fro over a border has no chunk sent twice to a client that says what it holds") {
  Bench bench;
  std::set<std::int32_t> held;  // x of the chunks that came
  std::size_t waited = 0;
  for (int step = 0; step < 40; ++step) {
    const std::int64_t centre = step % 2;
    std::vector<wire::KnownChunk> known;
    for (const std::int32_t x : held) {
      if (x < centre - 2 || x > centre + 2) continue;
      for (std::int32_t z = -2; z <= 2; ++z) {
        const auto hash = std::hash<ChunkKey>{}(ChunkKey{{x, 0, z}, Lod{}});
        known.push_back({wire::ChunkKey{x, 0, z, 0}, wire::Hash128{hash, 0}});
      }
    }
    bench.look_at(centre, 2, 0, known);
    if (step < 2) bench.client->await(waited += step == 0 ? 25 : 5);
    bench.carry_over();
    std::size_t chunks = 0;
    std::size_t confirmed = 0;
    for (const wire::Body kind : bench.output()) {
      chunks += kind == wire::Body::Chunk ? 1 : 0;
      confirmed += kind == wire::Body::Unchanged ? 1 : 0;
    }
    for (std::int64_t x = centre - 2; x <= centre + 2; ++x) held.insert(static_cast<std::int32_t>(x));
    CAPTURE(step);
    CHECK(chunks == (step == 0 ? 25 : step == 1 ? 5 : 0));
    CHECK(confirmed == (step < 2 ? 0 : 5));
  }
  CHECK(bench.fake.work->chunks == 30);
}

TEST_CASE("what a client says it knows is bounded, and forgotten with the View") {
  Bench bench;
  bench.fake.work->close_gate();
  std::vector<wire::KnownChunk> known;
  for (std::int32_t x = 0; x < 1000; ++x) known.push_back({wire::ChunkKey{x, 0, 0, 0}, wire::Hash128{1, 2}});
  known.push_back({wire::ChunkKey{0, 0, 0, 255}, wire::Hash128{1, 2}});  // no such level: passed over
  bench.look_at(0, 2, 0, known);
  CHECK(bench.session.known_chunks() == 3);
  for (int again = 0; again < 20; ++again) bench.say_view(again * 5000, 0, 0, known);
  CHECK(bench.session.known_chunks() <= Session::kKnownChunks);
  bench.look_at(1'000'000, 0);
  CHECK(bench.session.known_chunks() == 0);
}

TEST_CASE("Columns wait for a client that reads nothing") {
  Bench bench;
  bench.fake.work->last_mixed_anywhere = -10;  // air throughout the View
  bench.look_at(0, 20, 5);
  CHECK(bench.session.queued_bytes() < Session::kColumnBytes + 512);
  std::set<std::pair<std::int32_t, std::int32_t>> columns;
  for (bool more = true; more;) {
    const auto frames = bench.frames(4096);
    bench.session.pump();
    for (const auto& frame : frames) {
      const wire::Column& column = *(**protocol::read_message(frame)).body_as_Column();
      CHECK(columns.emplace(column.x(), column.z()).second);
    }
    more = !frames.empty();
  }
  CHECK(columns.size() == 41 * 41);
}

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
  const auto frames = bench.frames();
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
