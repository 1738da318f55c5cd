// A session's nearest chunks: wanted soon, and begun whatever else waits.
#include <catch2/catch.hpp>
#include <set>

#include "session_bench.h"
#include "views.h"

using namespace talus;
using namespace talus::server;

namespace {

bool is_near(ChunkKey key, std::int32_t centre_x = 0) {
  const auto x = key.coord.x - centre_x;
  return x * x + key.coord.y * key.coord.y + key.coord.z * key.coord.z < 4;
}

}  // namespace

TEST_CASE("the two nearest rings of a View are wanted soon") {
  SessionBench bench;
  bench.move_view(0, 3, 3);
  std::set<ChunkKey> near;
  for (const auto& [key, mailbox] : bench.source.waiting) {
    if (is_near(key)) near.insert(key);
  }
  CHECK(near.size() == 27);
  CHECK(bench.source.wanted_soon == near);
}

TEST_CASE("chunks requested next to a near chunk are urgent with it, and no others") {
  SessionBench bench;
  bench.source.together = 4;
  bench.move_view(1, 8);
  CHECK(bench.source.wanted_soon.contains(chunk_at(1)));
  for (const ChunkKey key : bench.source.wanted_soon) {
    CHECK((key.coord.x >> 2 == 0 || is_near(key, 1)));
  }
  CHECK(bench.source.wanted_soon.size() < bench.source.waiting.size());
}

TEST_CASE("a near chunk for which a request waits already is hastened") {
  SessionBench bench;
  bench.get_chunk(1, chunk_at(0));
  REQUIRE(bench.source.wanted_soon.empty());
  bench.move_view(0, 1);
  CHECK(bench.source.wanted_soon.contains(chunk_at(0)));
}

TEST_CASE("a chunk requested by id is wanted later") {
  SessionBench bench;
  bench.get_chunk(1, chunk_at(0));
  CHECK(bench.source.waiting.size() == 1);
  CHECK(bench.source.wanted_soon.empty());
}

TEST_CASE("chunks that wait and come near are wanted soon from then on") {
  SessionBench bench;
  bench.move_view(0, 2);
  REQUIRE(bench.source.waiting.contains(chunk_at(2)));
  CHECK_FALSE(bench.source.wanted_soon.contains(chunk_at(2)));
  bench.move_view(1, 2);
  CHECK(bench.source.wanted_soon.contains(chunk_at(2)));
  // Once.
  bench.source.wanted_soon.clear();
  bench.move_view(1, 3);
  CHECK_FALSE(bench.source.wanted_soon.contains(chunk_at(2)));
}

TEST_CASE("the nearest chunks are begun however many far ones wait, and no others") {
  SessionBench bench;
  bench.move_view(0, 20);
  REQUIRE(bench.source.waiting.size() == Delivery::kMaxViewInFlight);
  // As far as what waits stays in the View.
  bench.move_view(12, 20);
  std::size_t near = 0;
  for (const auto& [key, mailbox] : bench.source.waiting) near += is_near(key, 12) ? 1U : 0U;
  CHECK(near == 9);
  CHECK(bench.source.waiting.size() == Delivery::kMaxViewInFlight + 9);
}

TEST_CASE("the nearest chunks leave before far ones that the client has not taken, however a player moves") {
  SessionBench bench;
  bench.move_view(0, 20, 1);
  const std::size_t far = bench.source.waiting.size();
  REQUIRE(far >= Delivery::kMaxViewInFlight);
  bench.answer_all();
  bench.move_view(12, 20, 1);
  bench.answer_all();
  const auto sent = bench.output();
  REQUIRE(sent.size() == far + 27);
  for (std::size_t i = 0; i < sent.size(); ++i) {
    CAPTURE(i);
    CHECK(is_near(sent[i].key, 12) == (i < 27));
  }
}
