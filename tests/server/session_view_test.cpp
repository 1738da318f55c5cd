// A session's View: what is sent, confirmed, answered by UniformColumn, and dropped.
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "session_bench.h"
#include "views.h"

using namespace talus;
using namespace talus::server;
using Body = wire::Body;

namespace {

constexpr auto kRock = MaterialId{2};

std::vector<EncodedChunkPtr> scripted_chunks(const std::vector<ChunkKey>& keys, std::uint64_t revision = 0) {
  std::vector<EncodedChunkPtr> chunks;
  for (const ChunkKey key : keys) chunks.push_back(scripted_chunk(key, revision));
  return chunks;
}

}  // namespace

TEST_CASE("a View waits until it is applied") {
  SessionBench bench;
  bench.say_view(0, 1);
  CHECK(bench.session.view_waits());
  CHECK(bench.source.submitted == 0);
  bench.apply_view();
  CHECK_FALSE(bench.session.view_waits());
  CHECK(bench.source.submitted == 9);
}

TEST_CASE("each chunk of a View is sent once, for request id 0") {
  SessionBench bench;
  bench.move_view(0, 1);
  std::set<ChunkKey> sent;
  for (const SessionFrame& each : bench.run_dry()) {
    CHECK(each.kind == Body::Chunk);
    CHECK(each.id == 0);
    CHECK(sent.insert(each.key).second);
  }
  CHECK(sent.size() == 9);
}

TEST_CASE("the source receives the chunks of a View, and its next chunks if it moves on") {
  SessionBench bench;
  CHECK(bench.source.wanted.empty());
  bench.move_view(0, 2);
  REQUIRE(bench.source.wanted.size() == 1);
  CHECK(bench.source.wanted.front().x == ChunkRange{-2, 2});
  bench.move_view(1, 2);
  REQUIRE(bench.source.wanted.size() == 1);
  CHECK(bench.source.wanted.front().x == ChunkRange{-1, 3 + Heading::kAhead});
  CHECK(bench.source.wanted.front().z == ChunkRange{-2, 2});
  bench.session.abandon();
  CHECK(bench.source.wanted.empty());
}

TEST_CASE("a sent chunk that stays in the View is not sent again") {
  SessionBench bench;
  bench.move_view(0, 1);
  (void)bench.run_dry();
  bench.move_view(1, 1);
  CHECK(bench.run_dry().size() == 3);
}

TEST_CASE("a View has no more than kMaxViewInFlight chunks in flight") {
  SessionBench bench;
  bench.move_view(0, 20);
  CHECK(bench.source.waiting.size() == Delivery::kMaxViewInFlight);
}

TEST_CASE("a View has more chunks in flight while the source has little to do and the client takes them") {
  SessionBench bench;
  bench.source.little_to_do = true;
  bench.move_view(0, 20);
  CHECK(bench.source.waiting.size() == Delivery::kMaxViewAlone);
  // All wait for the client, who takes one by one.
  bench.answer_all();
  std::size_t begun = 0;
  for (int i = 0; i < 200; ++i) {
    (void)bench.output(1);
    begun = std::max(begun, bench.source.waiting.size());
  }
  CHECK(begun > 0);
  CHECK(begun < Delivery::kMaxViewInFlight);
  // Who has taken all is not held back any more.
  (void)bench.run_dry();
  bench.move_view(100, 20);
  CHECK(bench.source.waiting.size() == Delivery::kMaxViewAlone);
}

TEST_CASE("a View outside the world is accepted and has no chunks") {
  SessionBench bench;
  bench.move_view(0, 1);
  (void)bench.run_dry();
  bench.move_view(std::int64_t{1} << 40, 1);
  CHECK(bench.run_dry().empty());
  CHECK(bench.session.state() == Session::State::joined);
  bench.move_view(0, 1);
  CHECK(bench.run_dry().size() == 9);
}

TEST_CASE("a View without centre closes the session") {
  SessionBench bench;
  bench.receive([](auto& builder) { return wire::CreateView(builder, nullptr, nullptr, 1, 1); });
  CHECK(bench.output().at(0).code == wire::ErrorCode::malformed);
  CHECK(bench.session.state() == Session::State::closed);
}

TEST_CASE("a View over the limits is refused, and the View before stays") {
  SessionBench bench;
  bench.move_view(0, 0);
  bench.say_view(0, 49);
  CHECK_FALSE(bench.session.view_waits());
  const auto said = bench.run_dry();
  REQUIRE(kinds(said) == Kinds{Body::Error, Body::Chunk});
  CHECK(said[0].code == wire::ErrorCode::too_large);
  CHECK(said[0].id == 0);
}

TEST_CASE("rings whose levels or radii do not grow are refused") {
  SessionBench bench;
  const auto rings =
      GENERATE(std::vector{wire::LodRing{0, 9}}, std::vector{wire::LodRing{7, 9}},
               std::vector{wire::LodRing{1, 2}}, std::vector{wire::LodRing{2, 9}, wire::LodRing{1, 10}});
  bench.receive([&](auto& builder) {
    const wire::Voxel centre{};
    return wire::CreateView(builder, &centre, nullptr, 2, 0, builder.CreateVectorOfStructs(rings));
  });
  CHECK(bench.output().at(0).code == wire::ErrorCode::out_of_range);
}

TEST_CASE("chunks that left the View are dropped before they are sent") {
  SessionBench bench;
  bench.move_view(0, 1);
  bench.answer_all();
  bench.move_view(100, 0);
  const auto said = bench.run_dry();
  REQUIRE(kinds(said) == Kinds{Body::Chunk});
  CHECK(said[0].key == chunk_at(100));
}

TEST_CASE("chunks that left the View leave the source's queue") {
  SessionBench bench;
  bench.move_view(0, 1);
  bench.move_view(100, 0);
  CHECK(bench.source.waiting.size() == 1);
}

TEST_CASE("a chunk that left the View is still made for the request that waits for it") {
  SessionBench bench;
  bench.move_view(0, 0);
  bench.get_chunk(1, chunk_at(0));
  bench.move_view(100, 0);
  bench.answer_all();
  const auto said = bench.output();
  REQUIRE(said.size() == 2);
  CHECK(said[0].id + said[1].id == 1);
}

TEST_CASE("a chunk that left in a View that was never applied is sent again") {
  SessionBench bench;
  bench.move_view(0, 0);
  CHECK(bench.run_dry().size() == 1);
  const int away = GENERATE(0, 1, 5, 100);  // Views in between, of which the client dropped what it had
  for (int view = 1; view <= away; ++view) bench.say_view(view * 1000, 0);
  bench.move_view(0, 0);
  CHECK(bench.run_dry().size() == (away == 0 ? 0 : 1));
}

TEST_CASE("any number of Views of the same chunks between two applications has nothing sent again") {
  SessionBench bench;
  bench.move_view(0, 0);
  CHECK(bench.run_dry().size() == 1);
  for (int view = 0; view < 100; ++view) bench.say_view(0, 0);
  bench.move_view(0, 0);
  CHECK(bench.run_dry().empty());
}

TEST_CASE("a chunk in flight that left in a View that was never applied is sent once") {
  SessionBench bench;
  bench.move_view(0, 0);
  bench.say_view(1000, 0);
  bench.move_view(0, 0);
  CHECK(bench.run_dry().size() == 1);
}

TEST_CASE("a failed chunk of the View is reported without id, and not tried again") {
  SessionBench bench;
  bench.move_view(0, 0);
  bench.source.fail(chunk_at(0));
  bench.take_mail();
  const auto said = bench.output();
  REQUIRE(said.size() == 1);
  CHECK(said[0].code == wire::ErrorCode::internal);
  CHECK(said[0].id == 0);
  CHECK(bench.source.waiting.empty());
}

// ---- a View that is whole

TEST_CASE("a View with a number is said to be complete once, after its last chunk") {
  SessionBench bench;
  bench.view_number = 7;
  bench.move_view(0, 1);
  for (int chunk = 0; chunk < 8; ++chunk) {
    bench.source.answer(bench.source.waiting.begin()->first);
    bench.take_mail();
  }
  CHECK(kinds(bench.output()) == Kinds(8, Body::Chunk));
  CHECK(bench.output().empty());
  const auto said = bench.run_dry();
  REQUIRE(kinds(said) == Kinds{Body::Chunk, Body::ViewComplete});
  CHECK(said[1].view_number == 7);
  bench.ping();
  CHECK(kinds(bench.run_dry()) == Kinds{Body::Pong});
}

TEST_CASE("a View that is complete at once says so") {
  SessionBench bench;
  bench.view_number = 1;
  SECTION("outside the world") {
    bench.move_view(std::int64_t{1} << 40, 1);
  }
  SECTION("of columns") {
    bench.source.rows.last = -10;
    bench.move_view(0, 0);
    CHECK(bench.output(1).front().kind == Body::UniformColumn);
  }
  SECTION("of chunks that the client holds") {
    bench.source.in_memory[chunk_at(0)] = scripted_chunk(chunk_at(0));
    bench.say_view(0, 0, 0, {scripted_chunk(chunk_at(0))}, {chunk_at(0)});
    bench.apply_view();
    CHECK(bench.output(1).front().kind == Body::Unchanged);
  }
  SECTION("of the chunks of the View before") {
    bench.view_number = 0;
    bench.move_view(0, 1);
    CHECK(bench.run_dry().size() == 9);
    bench.view_number = 1;
    bench.move_view(0, 1);
  }
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::ViewComplete});
  CHECK(said[0].view_number == 1);
}

TEST_CASE("a View that was replaced before it was complete is never said to be") {
  SessionBench bench;
  bench.view_number = 1;
  bench.move_view(0, 0);
  bench.answer_all();  // in the outbox
  bench.view_number = 2;
  bench.say_view(0, 1);
  CHECK(kinds(bench.run_dry()) == Kinds{Body::Chunk});  // all of View 1
  bench.view_number = 3;
  bench.say_view(0, 1);
  bench.apply_view();
  const auto said = bench.run_dry();
  REQUIRE(said.size() == 9);
  CHECK(said.back().kind == Body::ViewComplete);
  CHECK(said.back().view_number == 3);
}

TEST_CASE("a View that a refused one would have replaced is said to be complete") {
  SessionBench bench;
  bench.view_number = 1;
  bench.move_view(0, 0);
  bench.view_number = 2;
  bench.say_view(0, 49);
  const auto said = bench.run_dry();
  REQUIRE(kinds(said) == Kinds{Body::Error, Body::Chunk, Body::ViewComplete});
  CHECK(said[0].about == wire::ErrorAbout::view);
  CHECK(said[0].view_number == 2);
  CHECK(said[2].view_number == 1);
}

TEST_CASE("a View whose chunk was given up is complete after the Error that names it") {
  SessionBench bench;
  bench.view_number = 4;
  bench.move_view(3, 0);
  bench.source.fail(chunk_at(3));
  bench.take_mail();
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Error, Body::ViewComplete});
  CHECK(said[0].about == wire::ErrorAbout::view_chunk);
  CHECK(said[0].key == chunk_at(3));
  CHECK(said[0].view_number == 4);
}

TEST_CASE("a View that ended by GoAway is not said to be complete") {
  SessionBench bench;
  bench.get_chunk(1, chunk_at(50));
  bench.view_number = 1;
  bench.move_view(0, 0);
  bench.session.go_away("ending", std::chrono::milliseconds{1});
  CHECK(kinds(bench.run_dry()) == Kinds{Body::GoAway, Body::Chunk});
}

// ---- scarce credit

TEST_CASE("with little credit a View and requests get half the bytes each, within one chunk") {
  constexpr std::uint32_t kOpen = 900;
  constexpr std::int32_t kRadius = 20;
  SessionBench bench{{.greet = false}};
  bench.limits.window_bytes = 1000;
  bench.limits.queued_bytes = 20'000;
  bench.hello();
  (void)bench.output();
  std::size_t largest = 0;
  const auto in_memory = [&](ChunkKey key) {
    const std::size_t payload = 50 + std::hash<ChunkKey>{}(key) % 500;
    bench.source.in_memory[key] = scripted_chunk(key, 0, payload);
    largest = std::max(largest, bench.source.in_memory[key]->frame_bytes());
  };
  for (const ChunkKey key : chunks_in_view({{0, 0, 0}, {}, kRadius, 0, {}})) in_memory(key);
  std::uint32_t last_id = 0;
  const auto ask = [&] {
    ++last_id;
    const ChunkKey key = chunk_at(static_cast<std::int32_t>(1000 + last_id));
    in_memory(key);
    bench.get_chunk(last_id, key);
  };
  while (last_id < kOpen) ask();
  std::uint64_t taken = 0;
  // What was sent before the View was there is not shared.
  const auto read = [&](std::uint64_t& to_requests, std::uint64_t& to_view) {
    for (const SessionFrame& each : bench.output()) {
      REQUIRE(each.kind == Body::Chunk);
      (each.id == 0 ? to_view : to_requests) += each.frame_bytes;
      taken += each.frame_bytes;
      if (each.id != 0) ask();
    }
    bench.credit(taken);
  };
  std::uint64_t ignored = 0;
  read(ignored, ignored);
  bench.move_view(0, kRadius);
  while (ignored < 30'000) read(ignored, ignored);  // the outbox was full of requests
  std::uint64_t to_requests = 0;
  std::uint64_t to_view = 0;
  for (int turn = 0; turn < 200; ++turn) {
    read(to_requests, to_view);
    CAPTURE(turn, to_requests, to_view);
    CHECK(to_requests <= to_view + 2 * largest);
    CHECK(to_view <= to_requests + 2 * largest);
  }
  CHECK(to_view > 100'000);
}

// ---- a full queue

TEST_CASE("a full queue delays a View, and says nothing of it") {
  SessionBench bench;
  bench.source.queue_places = 1;
  bench.move_view(0, 1);
  CHECK(bench.output().empty());
  CHECK(kinds(bench.run_dry()) == Kinds(9, Body::Chunk));
}

TEST_CASE("a View that a full queue refused submits nothing before mail comes") {
  SessionBench bench;
  bench.source.queue_places = 0;
  bench.move_view(0, 1);
  CHECK(bench.source.refused == 1);
  for (int event = 0; event < 10; ++event) bench.ping();
  CHECK(bench.source.refused == 1);
}

TEST_CASE(
    "a View that a full queue refused is tried again when the last request is cancelled that would bring "
    "mail") {
  SessionBench bench;
  bench.source.queue_places = 1;
  bench.get_chunk(7, chunk_at(100));
  bench.move_view(0, 1);
  REQUIRE(bench.source.refused == 1);
  bench.source.queue_places = 100;
  bench.cancel(7);
  CHECK(bench.source.waiting.size() == 9);
}

TEST_CASE("QueueHasRoom starts a View that a full queue refused") {
  SessionBench bench;
  bench.source.queue_places = 0;
  bench.move_view(0, 1);
  bench.source.queue_places = 100;
  bench.mailbox->put(QueueHasRoom{});
  bench.take_mail();
  CHECK(bench.source.waiting.size() == 9);
}

TEST_CASE("a new View in memory is sent while the queue is full") {
  SessionBench bench;
  bench.source.queue_places = 0;
  bench.move_view(0, 1);
  bench.source.in_memory[chunk_at(100)] = scripted_chunk(chunk_at(100));
  bench.move_view(100, 0);
  CHECK(kinds(bench.output()) == Kinds{Body::Chunk});
}

// ---- what the client holds

TEST_CASE("a chunk of the View that the client holds is confirmed, with its revision") {
  SessionBench bench;
  bench.source.in_memory[chunk_at(0)] = scripted_chunk(chunk_at(0), 3);
  bench.say_view(0, 0, 0, {scripted_chunk(chunk_at(0), 3)}, {chunk_at(0)});
  bench.apply_view();
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Unchanged});
  CHECK(said[0].revision == 3);
  CHECK(said[0].id == 0);
}

TEST_CASE("a chunk of the View of which the client holds another version is sent") {
  SessionBench bench;
  bench.source.in_memory[chunk_at(0)] = scripted_chunk(chunk_at(0), 3);
  bench.say_view(0, 0, 0, {scripted_chunk(chunk_at(0), 2)}, {chunk_at(0)});
  bench.apply_view();
  CHECK(kinds(bench.output()) == Kinds{Body::Chunk});
}

TEST_CASE("a walk to and fro over a border sends no chunk twice to a client that says what it holds") {
  SessionBench bench;
  std::set<std::int32_t> held;  // x of the chunks that came
  for (int step = 0; step < 40; ++step) {
    const std::int64_t centre = step % 2;
    std::vector<ChunkKey> known;
    for (const std::int32_t x : held) {
      if (x < centre - 2 || x > centre + 2) continue;
      for (std::int32_t z = -2; z <= 2; ++z) known.push_back(chunk_at(x, 0, z));
    }
    bench.say_view(centre, 2, 0, scripted_chunks(known), known);
    bench.apply_view();
    std::size_t chunks = 0;
    std::size_t confirmed = 0;
    for (const SessionFrame& each : bench.run_dry()) {
      chunks += each.kind == Body::Chunk ? 1 : 0;
      confirmed += each.kind == Body::Unchanged ? 1 : 0;
    }
    for (std::int64_t x = centre - 2; x <= centre + 2; ++x) held.insert(static_cast<std::int32_t>(x));
    CAPTURE(step);
    CHECK(chunks == (step == 0 ? 25 : step == 1 ? 5 : 0));
    CHECK(confirmed == (step < 2 ? 0 : 5));
  }
}

// ---- columns

TEST_CASE("air that is known without generating comes as one UniformColumn of revision 0") {
  SessionBench bench;
  bench.source.rows.last = 0;
  bench.move_view(0, 0, 3);
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::UniformColumn});
  CHECK(said[0].runs == Runs{{1, 3, 0}});
  CHECK(said[0].revision == 0);
  CHECK(bench.source.waiting.size() == 4);
}

TEST_CASE("a column that becomes known while its chunks wait is sent in one message") {
  SessionBench bench;
  bench.move_view(0, 0, 3);  // rows -3 to 3, all mixed for all that is known
  bench.source.rows = {-1, 0, kRock};
  bench.source.answer(chunk_at(0, 2));
  bench.take_mail();
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::UniformColumn});
  CHECK(said[0].runs == Runs{{-3, -2, 2}, {1, 3, 0}});
}

TEST_CASE("chunks that a UniformColumn answered are not answered again when they come") {
  SessionBench bench;
  bench.move_view(0, 0, 3);
  bench.source.rows = {-1, 0, kRock};
  bench.source.answer(chunk_at(0, 2));
  bench.take_mail();
  CHECK(kinds(bench.output()) == Kinds{Body::UniformColumn});
  CHECK(kinds(bench.run_dry()) == Kinds{Body::Chunk, Body::Chunk});
}

TEST_CASE(
    "a chunk that a UniformColumn answered is sent when it leaves the View and comes back before it came") {
  SessionBench bench;
  bench.move_view(0, 0, 1);
  bench.source.rows = {0, 0, kRock};
  bench.source.answer(chunk_at(0, -1));
  bench.take_mail();
  (void)bench.output();
  bench.move_view(100, 0);
  bench.source.rows = {};
  bench.move_view(0, 0, 1);
  std::set<ChunkKey> sent;
  for (const SessionFrame& each : bench.run_dry()) sent.insert(each.key);
  CHECK(sent == std::set{chunk_at(0, -1), chunk_at(0, 0), chunk_at(0, 1)});
}

TEST_CASE("a UniformColumn says nothing of a chunk that waits to be sent") {
  SessionBench bench;
  bench.move_view(0, 0, 2);
  bench.source.answer(chunk_at(0, 2));
  bench.take_mail();  // in the outbox now
  bench.source.rows = {-2, 0, kRock};
  bench.source.answer(chunk_at(0, 1));
  bench.take_mail();
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::UniformColumn, Body::Chunk});
  CHECK(said[0].runs == Runs{{1, 1, 0}});
  CHECK(said[1].key == chunk_at(0, 2));
}

TEST_CASE("a uniform chunk that the client holds is answered by UniformColumn") {
  SessionBench bench;
  bench.source.rows.last = -1;
  bench.say_view(0, 0, 0, {scripted_chunk(chunk_at(0))}, {chunk_at(0)});
  bench.apply_view();
  CHECK(kinds(bench.output()) == Kinds{Body::UniformColumn});
}

TEST_CASE("columns that are known come without credit, each once") {
  SessionBench bench{{.greet = false}};
  bench.limits.window_bytes = 1;
  bench.hello();
  (void)bench.output();
  bench.source.rows = {0, 0, kRock};
  bench.move_view(0, 5, 1);
  bench.answer_all();
  std::vector<ChunkKey> columns;
  for (bool more = true; more;) {
    const auto said = bench.output(100);
    for (const SessionFrame& each : said) {
      if (each.kind != Body::UniformColumn) continue;
      columns.push_back(each.key);
      CHECK(each.runs == Runs{{-1, -1, 2}, {1, 1, 0}});
    }
    more = !said.empty();
  }
  CHECK(columns.size() == 11 * 11);
  CHECK(std::set(columns.begin(), columns.end()).size() == 11 * 11);
}

TEST_CASE("UniformColumns wait for a client that reads nothing") {
  SessionBench bench;
  bench.source.rows.last = -10;  // air throughout the View
  bench.move_view(0, 20, 5);
  CHECK(bench.session.queued_bytes() < Delivery::kMaxColumnBytes + 512);
  std::set<ChunkKey> columns;
  for (bool more = true; more;) {
    const auto said = bench.output(4096);
    for (const SessionFrame& each : said) CHECK(columns.insert(each.key).second);
    more = !said.empty();
  }
  CHECK(columns.size() == 41 * 41);
}
