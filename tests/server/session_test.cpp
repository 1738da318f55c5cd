// The protocol: states, requests and their answers, errors.
#include "player/session/session.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "session_bench.h"

using namespace talus;
using namespace talus::server;
using namespace std::chrono_literals;
using Body = wire::Body;
using State = Session::State;

TEST_CASE("a session is connected until its Hello, then joined") {
  SessionBench bench{{.greet = false}};
  CHECK(bench.session.state() == State::connected);
  bench.hello();
  CHECK(bench.session.state() == State::joined);
  CHECK(kinds(bench.output()) == Kinds{Body::Welcome});
}

TEST_CASE("any message before Hello closes the session") {
  SessionBench bench{{.greet = false}};
  bench.ping();
  CHECK(bench.output().at(0).code == wire::ErrorCode::unexpected);
  CHECK(bench.session.state() == State::closed);
}

TEST_CASE("a second Hello closes the session") {
  SessionBench bench;
  bench.hello();
  CHECK(bench.output().at(0).code == wire::ErrorCode::unexpected);
  CHECK(bench.session.state() == State::closed);
}

TEST_CASE("a client that decodes only an older codec is refused") {
  SessionBench bench{{.greet = false}};
  bench.hello("", kCodecVersion - 1);
  CHECK(bench.output().at(0).code == wire::ErrorCode::version);
  CHECK(bench.session.state() == State::closed);
}

TEST_CASE("a client without a codec of this server gets the server's codec, and the first 16 of its own") {
  const auto told = [](const std::vector<std::uint8_t>& codecs) {
    SessionBench bench{{.greet = false}};
    bench.receive([&](auto& builder) {
      const auto list = builder.CreateVector(codecs);
      return wire::CreateHello(builder, protocol::kOldestProtocol, protocol::kProtocolVersion, list,
                               builder.CreateString(""));
    });
    return bench.output().at(0).text;
  };
  CHECK_THAT(told({}), Catch::EndsWith("this client decodes none"));
  CHECK_THAT(told({200, 201}), Catch::EndsWith("this client decodes 200, 201"));
  CHECK_THAT(told(std::vector<std::uint8_t>(17, 9)),
             Catch::EndsWith("decodes 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9"));
}

TEST_CASE("Hello texts over 4,096 bytes close the session") {
  SessionBench bench{{.greet = false}};
  bench.hello(std::string(4097, 'x'));
  CHECK(bench.output().at(0).code == wire::ErrorCode::malformed);
  CHECK(bench.session.state() == State::closed);
}

TEST_CASE("a message of servers closes the session") {
  SessionBench bench;
  bench.receive([](auto& builder) { return wire::CreatePong(builder, 1); });
  CHECK(bench.output().at(0).code == wire::ErrorCode::unexpected);
  CHECK(bench.session.state() == State::closed);
}

TEST_CASE("bytes that are not a message close the session") {
  SessionBench bench;
  const std::vector<std::byte> noise(64, std::byte{0xFF});
  bench.session.receive(noise);
  CHECK(bench.output().at(0).code == wire::ErrorCode::malformed);
  CHECK(bench.session.state() == State::closed);
}

TEST_CASE("request id 0 closes the session") {
  const bool heights = GENERATE(true, false);
  SessionBench bench;
  if (heights) bench.get_heights(0);
  if (!heights) bench.get_chunk(0, chunk_at(0));
  CHECK(bench.output().at(0).code == wire::ErrorCode::malformed);
  CHECK(bench.session.state() == State::closed);
}

TEST_CASE("a Credit over what was sent closes the session") {
  SessionBench bench;
  bench.credit(1);
  CHECK(bench.output().at(0).code == wire::ErrorCode::malformed);
  CHECK(bench.session.state() == State::closed);
}

TEST_CASE("a frame in progress is in the budget, before Hello too") {
  constexpr std::uint64_t kLimit = std::uint64_t{256} << 20;
  SessionBench bench{{.memory_bytes = kLimit, .greet = false}};
  bench.session.pump();
  const auto before = bench.memory.used(MemoryUse::sessions);
  bench.session.holds_input(10'000'000);
  CHECK(bench.memory.used(MemoryUse::sessions) >= before + 9'990'000);
  CHECK_FALSE(bench.session.closing());
  bench.session.holds_input(0);
  bench.session.pump();
  CHECK(bench.memory.used(MemoryUse::sessions) <= before + 4096);
}

TEST_CASE("if memory is short a large frame ends its session, and a common one does not") {
  constexpr std::uint64_t kLimit = std::uint64_t{256} << 20;
  SessionBench bench{{.memory_bytes = kLimit}};
  bench.memory.set(MemoryUse::jobs, kLimit);
  bench.session.holds_input(Session::kMaxFrameBytesAnyway);
  CHECK_FALSE(bench.session.closing());
  bench.session.holds_input(Session::kMaxFrameBytesAnyway + 1);
  CHECK(bench.session.closing());
  CHECK(bench.output().back().code == wire::ErrorCode::overloaded);
}

TEST_CASE("a View that waits is in the budget with what it comes to take") {
  constexpr std::uint64_t kLimit = std::uint64_t{256} << 20;
  SessionBench bench{{.memory_bytes = kLimit}};
  const auto before = bench.memory.used(MemoryUse::sessions);
  bench.say_view(0, 40);
  const auto promised = bench.memory.used(MemoryUse::sessions);
  constexpr std::uint64_t kPage = 4096;  // the budget is told of no less
  CHECK(promised + kPage >= before + 81 * 81 * Session::kViewBytesPerChunk);
  bench.apply_view();
  // Those that wait for the source count beside it.
  CHECK(bench.memory.used(MemoryUse::sessions) <= promised + Delivery::kMaxViewInFlight * 256 + kPage);
}

TEST_CASE("if memory is short a View may move, and a larger one is refused with a time to retry after") {
  constexpr std::uint64_t kLimit = std::uint64_t{256} << 20;
  SessionBench bench{{.memory_bytes = kLimit}};
  bench.move_view(0, 2);
  (void)bench.run_dry();
  bench.memory.set(MemoryUse::jobs, kLimit);
  bench.say_view(1, 2);
  CHECK(bench.output().empty());
  bench.say_view(1, 3);
  const auto said = bench.output();
  REQUIRE(said.size() == 1);
  CHECK(said[0].about == wire::ErrorAbout::view);
  CHECK(said[0].code == wire::ErrorCode::overloaded);
  CHECK(said[0].retry_after_ms > 0);
  bench.memory.set(MemoryUse::jobs, 0);
  bench.say_view(1, 3);
  CHECK(bench.output().empty());
}

TEST_CASE("a session that failed says so and nothing else") {
  SessionBench bench;
  bench.get_chunk(1, chunk_at(5));
  bench.source.answer(chunk_at(5));
  bench.receive([](auto& builder) { return wire::CreatePong(builder, 1); });
  bench.take_mail();
  bench.get_chunk(2, chunk_at(6));
  CHECK(kinds(bench.output()) == Kinds{Body::Error});
}

TEST_CASE("a session that failed leaves the source's queue") {
  SessionBench bench;
  bench.get_chunk(1, chunk_at(5));
  bench.get_heights(2);
  bench.move_view(0, 1);
  bench.session.timed_out("silence");
  CHECK(bench.source.waiting.empty());
  CHECK(bench.source.waiting_heights.empty());
}

TEST_CASE("a chunk in memory is answered at once, with its revision") {
  SessionBench bench;
  bench.source.in_memory[chunk_at(5)] = scripted_chunk(chunk_at(5), 7);
  bench.get_chunk(1, chunk_at(5));
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Chunk});
  CHECK(said[0].id == 1);
  CHECK(said[0].revision == 7);
  CHECK(bench.source.submitted == 0);
}

TEST_CASE("a request whose known hash is the chunk's is answered by Unchanged, with the revision") {
  SessionBench bench;
  const auto chunk = scripted_chunk(chunk_at(5), 7);
  bench.source.in_memory[chunk_at(5)] = chunk;
  bench.get_chunk(1, chunk_at(5), chunk);
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Unchanged});
  CHECK(said[0].revision == 7);
}

TEST_CASE(
    "a uniform chunk is answered without credit, before chunks that wait for it, and counts in the total") {
  SessionBench bench{{.rates = {{{1, 1}, {}, {}}, {}}, .greet = false}};
  bench.limits.window_bytes = 1;
  bench.hello();
  (void)bench.output();
  bench.source.in_memory[chunk_at(1)] = scripted_chunk(chunk_at(1));
  for (int x = 2; x <= 9; ++x) bench.source.in_memory[chunk_at(x)] = uniform_chunk(chunk_at(x));
  bench.get_chunk(1, chunk_at(1));
  std::uint64_t taken = bench.output().at(0).frame_bytes;
  // The window is full, and the rate of chunks is used up.
  bench.get_chunk(100, chunk_at(1));
  for (std::uint32_t x = 2; x <= 9; ++x) bench.get_chunk(x, chunk_at(static_cast<std::int32_t>(x)));
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds(8, Body::Chunk));
  for (std::uint32_t i = 0; i < 8; ++i) {
    CHECK(said[i].id == i + 2);
    CHECK(said[i].key == chunk_at(static_cast<std::int32_t>(i) + 2));
    taken += said[i].frame_bytes;
  }
  bench.get_chunk(2, chunk_at(2));  // its id is free
  taken += bench.output().at(0).frame_bytes;
  bench.credit(taken);
  CHECK(bench.session.state() == State::joined);
  bench.clock.advance(1s);
  CHECK(bench.output().at(0).id == 100);
}

TEST_CASE("two requests for one chunk are one submission and two answers") {
  SessionBench bench;
  bench.get_chunk(1, chunk_at(5));
  bench.get_chunk(2, chunk_at(5));
  bench.answer_all();
  CHECK(bench.source.submitted == 1);
  CHECK(kinds(bench.output()) == Kinds{Body::Chunk, Body::Chunk});
}

TEST_CASE("an id that is still pending is refused, and its first request is answered") {
  SessionBench bench;
  bench.get_chunk(1, chunk_at(5));
  bench.get_chunk(1, chunk_at(6));
  CHECK(bench.output().at(0).code == wire::ErrorCode::duplicate_id);
  bench.answer_all();
  CHECK(bench.output().at(0).key == chunk_at(5));
}

TEST_CASE("an id that a message uses twice is refused the second time, whatever became of the first") {
  SessionBench bench;
  const ChunkKey outside{{1 << 30, 0, 0}, Lod::of(1)};
  const ChunkKey second = GENERATE(true, false) ? outside : chunk_at(1);
  bench.get_chunks({{5, outside}, {5, second}, {6, chunk_at(2)}});
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Error, Body::Error});
  CHECK(said[0].code == wire::ErrorCode::out_of_range);
  CHECK(said[0].about == wire::ErrorAbout::request);
  CHECK(said[0].id == 5);
  CHECK(said[1].code == wire::ErrorCode::duplicate_id);
  CHECK(said[1].about == wire::ErrorAbout::repeated_request);
  CHECK(said[1].repeated_id == 5);
  CHECK(said[1].id == 5);
  CHECK(bench.source.waiting.size() == 1);
  bench.get_chunk(5, chunk_at(1));  // in the next message it is free
  CHECK(bench.source.waiting.size() == 2);
}

TEST_CASE("an Edit keeps the rules of ids") {
  SessionBench bench;
  bench.get_chunk(3, chunk_at(5));
  bench.edit(3);
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Error});
  CHECK(said[0].code == wire::ErrorCode::duplicate_id);
  CHECK(said[0].repeated_id == 3);
  bench.edit(0);
  CHECK(bench.output().at(0).code == wire::ErrorCode::malformed);
  CHECK(bench.session.state() == State::closed);
}

TEST_CASE("an answered id may be used again") {
  SessionBench bench;
  for (int again = 0; again < 3; ++again) {
    bench.get_chunk(1, chunk_at(again));
    bench.answer_all();
    CHECK(kinds(bench.output()) == Kinds{Body::Chunk});
  }
}

TEST_CASE("more requests than requests_in_flight are refused by their id") {
  SessionBench bench;
  bench.limits.requests_in_flight = 2;
  for (std::uint32_t id = 1; id <= 3; ++id) bench.get_chunk(id, chunk_at(0));
  const auto said = bench.output();
  REQUIRE(said.size() == 1);
  CHECK(said[0].code == wire::ErrorCode::too_many_requests);
  CHECK(said[0].id == 3);
}

TEST_CASE("a chunk outside the world is refused by its id") {
  SessionBench bench;
  bench.get_chunk(1, {{1 << 30, 0, 0}, Lod::of(1)});
  const auto said = bench.output();
  REQUIRE(said.size() == 1);
  CHECK(said[0].code == wire::ErrorCode::out_of_range);
  CHECK(said[0].id == 1);
}

TEST_CASE("a chunk that could not be generated is an Error that says to retry") {
  SessionBench bench;
  bench.get_chunk(1, chunk_at(5));
  bench.source.fail(chunk_at(5));
  bench.take_mail();
  const auto said = bench.output();
  REQUIRE(said.size() == 1);
  CHECK(said[0].code == wire::ErrorCode::internal);
  CHECK(said[0].retry_after_ms > 0);
}

TEST_CASE("a cancelled request leaves the source's queue") {
  SessionBench bench;
  bench.get_chunk(1, chunk_at(5));
  bench.cancel(1);
  CHECK(bench.source.waiting.empty());
  CHECK(bench.output().at(0).code == wire::ErrorCode::cancelled);
}

TEST_CASE("a cancelled request keeps the chunk for the other request that waits") {
  SessionBench bench;
  bench.get_chunk(1, chunk_at(5));
  bench.get_chunk(2, chunk_at(5));
  bench.cancel(1);
  bench.answer_all();
  CHECK(kinds(bench.output()) == Kinds{Body::Error, Body::Chunk});
}

TEST_CASE("an answer that a Cancel missed is not sent") {
  SessionBench bench;
  bench.get_chunk(1, chunk_at(5));
  bench.source.answer(chunk_at(5));
  bench.cancel(1);
  bench.take_mail();
  CHECK(kinds(bench.output()) == Kinds{Body::Error});
}

TEST_CASE("a chunk that waits for credit can still be cancelled") {
  SessionBench bench;
  bench.get_chunk(1, chunk_at(5));
  bench.answer_all();
  bench.cancel(1);
  CHECK(kinds(bench.output()) == Kinds{Body::Error});
}

TEST_CASE("heights are answered by their request's id") {
  SessionBench bench;
  bench.get_heights(4);
  bench.source.answer_heights(bench.source.waiting_heights.begin()->first);
  bench.take_mail();
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Heights});
  CHECK(said[0].id == 4);
}

TEST_CASE("heights that a Cancel missed do not answer a later request of the same id") {
  SessionBench bench;
  bench.get_heights(4);
  bench.source.answer_heights(bench.source.waiting_heights.begin()->first);
  bench.cancel(4);
  bench.get_heights(4);
  bench.take_mail();
  CHECK(kinds(bench.output()) == Kinds{Body::Error});
  CHECK(bench.source.waiting_heights.size() == 1);
}

TEST_CASE("a height outside the world is refused by its id") {
  SessionBench bench;
  bench.get_heights(4, std::int64_t{1} << 36);
  const auto said = bench.output();
  REQUIRE(said.size() == 1);
  CHECK(said[0].code == wire::ErrorCode::out_of_range);
  CHECK(said[0].id == 4);
}

TEST_CASE("fields that Welcome does not have, or too many, are refused by the request's id") {
  SessionBench bench;
  const auto ask = [&](const std::vector<std::uint8_t>& fields) {
    bench.receive([&](auto& builder) {
      const auto columns = builder.CreateVectorOfStructs(std::vector{wire::ColumnPos{0, 0}});
      return wire::CreateGetHeights(builder, 4, columns, true, builder.CreateVector(fields));
    });
    return bench.output();
  };
  auto said = ask({0, 255});  // the bench's world has none
  REQUIRE(said.size() == 1);
  CHECK(said[0].code == wire::ErrorCode::out_of_range);
  CHECK(said[0].id == 4);
  said = ask(std::vector<std::uint8_t>(17));
  REQUIRE(said.size() == 1);
  CHECK(said[0].code == wire::ErrorCode::too_large);
}

TEST_CASE("heights in more tiles than the world allows are refused") {
  SessionBench bench;
  bench.limits.height_tiles_per_request = 1;
  bench.receive([](auto& builder) {
    const std::vector columns{wire::ColumnPos{0, 0}, wire::ColumnPos{31, 31}, wire::ColumnPos{32, 0}};
    return wire::CreateGetHeights(builder, 1, builder.CreateVectorOfStructs(columns));
  });
  CHECK(bench.output().at(0).code == wire::ErrorCode::too_large);
}

TEST_CASE("a full queue refuses a request by its id, with a time to retry after") {
  SessionBench bench;
  bench.source.queue_places = 1;
  bench.get_chunk(1, chunk_at(5));
  bench.get_chunk(2, chunk_at(6));
  const auto said = bench.output();
  REQUIRE(said.size() == 1);
  CHECK(said[0].code == wire::ErrorCode::overloaded);
  CHECK(said[0].id == 2);
  CHECK(said[0].retry_after_ms > 0);
}

TEST_CASE("near the memory limit heights are refused with a time to retry after") {
  SessionBench bench{{.memory_bytes = 800U << 20}};
  bench.memory.set(MemoryUse::generators, 700U << 20);
  bench.get_heights(3);
  const auto said = bench.output();
  REQUIRE(said.size() == 1);
  CHECK(said[0].code == wire::ErrorCode::overloaded);
  CHECK(said[0].retry_after_ms > 0);
}

TEST_CASE("chunks that wait for the source count against what may wait for the client") {
  constexpr std::size_t kFit = 16;
  SessionBench bench;
  bench.limits.queued_bytes = kFit * Delivery::kExpectedChunkBytes;
  for (std::uint32_t id = 1; id <= 100; ++id) bench.get_chunk(id, chunk_at(static_cast<std::int32_t>(id)));
  CHECK(bench.source.waiting.size() == kFit);
}

TEST_CASE("a chunk that waits for the source counts as much as the largest that came") {
  SessionBench bench;
  bench.limits.queued_bytes = 64 * 1024;
  bench.source.payload_bytes = 15 * 1024;
  bench.get_chunk(1, chunk_at(1));
  bench.answer_all();
  (void)bench.output();
  for (std::uint32_t id = 2; id <= 100; ++id) bench.get_chunk(id, chunk_at(static_cast<std::int32_t>(id)));
  CHECK(bench.source.waiting.size() == 5);
}

TEST_CASE("no more than kMaxWaits chunks of a session wait for the source") {
  SessionBench bench;
  for (std::uint32_t id = 1; id <= 500; ++id) bench.get_chunk(id, chunk_at(static_cast<std::int32_t>(id)));
  CHECK(bench.source.waiting.size() == Delivery::kMaxWaits);
}

TEST_CASE("frames that may be written at once may be written at any reading of the clock") {
  SessionBench bench;
  const auto before = bench.clock.now();
  bench.clock.advance(1s);
  CHECK(bench.session.sendable_at() == Clock::time_point::max());
  bench.ping();
  CHECK(bench.session.sendable_at() <= before);
  (void)bench.output();
  bench.get_chunk(1, chunk_at(0));
  bench.answer_all();
  CHECK(bench.session.sendable_at() <= before);
}

TEST_CASE("an idle session counts kIdleBytes of memory, and returns to it") {
  SessionBench bench;
  bench.source.payload_bytes = 100'000;
  bench.get_chunk(1, chunk_at(5));
  bench.answer_all();
  CHECK(bench.memory.used(MemoryUse::sessions) >= Session::kIdleBytes + 100'000);
  (void)bench.output();
  CHECK(bench.memory.used(MemoryUse::sessions) <= Session::kIdleBytes + 4096);
}
