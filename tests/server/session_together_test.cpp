// Chunks of a View that are made together are asked for together.
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "session_bench.h"
#include "views.h"

using namespace talus;
using namespace talus::server;
using Body = wire::Body;

namespace {

struct Bench : SessionBench {
  Bench() { source.together = 4; }
};

bool same_square(ChunkKey a, ChunkKey b) {
  return a.coord.x >> 2 == b.coord.x >> 2 && a.coord.z >> 2 == b.coord.z >> 2;
}

}  // namespace

TEST_CASE("the chunks of each square of columns are requested at once, the nearest first") {
  Bench bench;
  bench.move_view(1, 3);
  REQUIRE_FALSE(bench.source.submissions.empty());
  const auto& first = bench.source.submissions.front();
  CHECK(first.front() == chunk_at(1));
  CHECK(first.size() == 16);
  (void)bench.run_dry();
  std::set<ChunkKey> asked;
  for (const auto& submission : bench.source.submissions) {
    for (const ChunkKey key : submission) {
      CHECK(same_square(key, submission.front()));
      CHECK(asked.insert(key).second);
    }
  }
  CHECK(asked.size() == 49);
  CHECK(bench.source.submissions.size() <= 9);  // 3 x 3 squares, none asked twice
}

TEST_CASE("a chunk much farther away than the nearest of its square is requested in its turn") {
  Bench bench;
  bench.move_view(0, 1, 9);
  const auto& first = bench.source.submissions.front();
  for (const ChunkKey key : first) CHECK(std::abs(key.coord.y) <= 4);
  CHECK(first.size() > 4);
  (void)bench.run_dry();
  CHECK(bench.source.submitted == 9 * 19);
}

TEST_CASE("a chunk of a square that a full queue refuses is requested again") {
  Bench bench;
  bench.source.queue_places = 5;
  bench.move_view(0, 2);
  CHECK(bench.source.waiting.size() == 5);
  CHECK(bench.run_dry().size() == 25);
  CHECK(bench.source.submitted == 25);
}

TEST_CASE("a chunk that a request waits for is not asked for again for the View") {
  Bench bench;
  bench.get_chunk(7, chunk_at(1));
  bench.move_view(0, 1);
  CHECK(bench.source.submitted == 9);
  std::size_t to_request = 0;
  for (const SessionFrame& said : bench.run_dry()) to_request += said.id == 7 ? 1U : 0U;
  CHECK(to_request == 1);
}

TEST_CASE("uniform chunks of a square are sent as columns, and not requested") {
  Bench bench;
  bench.source.rows = {0, 0, MaterialId{2}};
  bench.move_view(0, 1, 2);
  CHECK(bench.source.submitted == 9);
  std::size_t columns = 0;
  for (const SessionFrame& said : bench.run_dry()) columns += said.kind == Body::UniformColumn ? 1U : 0U;
  CHECK(columns == 9);
}

TEST_CASE(
    "a chunk that waits for the client is not sent in its column as well, whichever clients wait for it") {
  Bench bench;
  bench.move_view(0, 0);
  bench.answer_all();               // the View's chunk waits to be written
  bench.get_chunk(7, chunk_at(0));  // and is in no memory any more: the request has it made again
  REQUIRE(bench.source.waiting.size() == 1);
  bench.source.rows = {5, 5, MaterialId{2}};
  bench.move_view(0, 0, 1);  // tells the column, of which that chunk is
  std::size_t as_chunk = 0;
  std::size_t in_column = 0;
  for (const SessionFrame& said : bench.run_dry()) {
    as_chunk += said.kind == Body::Chunk && said.id == 0 && said.key == chunk_at(0) ? 1U : 0U;
    for (const auto& [first, last, material] : said.runs) in_column += first <= 0 && 0 <= last ? 1U : 0U;
  }
  CHECK(as_chunk == 1);
  CHECK(in_column == 0);
}

TEST_CASE("a View leaves requests room to wait for chunks of their own") {
  Bench bench;
  bench.source.together = 16;
  bench.move_view(8, 8, 4);
  // The nearest are begun one by one where there is no room for those beside them.
  constexpr std::size_t kNearest = 27;
  const std::size_t view_waits = bench.source.waiting.size();
  CHECK(view_waits >= Delivery::kMaxViewWaits);
  CHECK(view_waits <= Delivery::kMaxViewWaits + kNearest);
  for (std::uint32_t id = 1; id <= 20; ++id)
    bench.get_chunk(id, chunk_at(1000 + static_cast<std::int32_t>(id)));
  CHECK(bench.source.waiting.size() == view_waits + 20);
}

TEST_CASE("a session that lost an answer for want of memory ends and says so") {
  Bench bench;
  bench.move_view(0, 1);
  bench.mailbox->lose_mail();
  bench.ping();
  const auto said = bench.output();
  REQUIRE_FALSE(said.empty());
  CHECK(said.back().code == wire::ErrorCode::internal);
  CHECK(bench.session.closing());
  CHECK(bench.source.waiting.empty());
}
