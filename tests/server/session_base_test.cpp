// A View of a client that makes chunks by itself: edited ones come, and no other.
#include <algorithm>
#include <catch2/catch.hpp>
#include <memory>
#include <set>
#include <vector>

#include "session_bench.h"

using namespace talus;
using namespace talus::server;
using Body = wire::Body;

namespace {

const std::shared_ptr<const PublishedWorld> kPublished =
    std::make_shared<const PublishedWorld>(PublishedWorld{"seed = 1", {}});

struct Bench : SessionBench {
  /// `remembers`: the source knows which voxels an edit changed.
  explicit Bench(bool remembers = true) : SessionBench{{.published = kPublished}} {
    has_base = true;
    if (!remembers) return;
    source.changes = [this](ChunkKey key, std::uint64_t since) -> std::optional<ChangedVoxels> {
      const auto edited = source.revisions.find(key);
      if (edited == source.revisions.end()) return std::nullopt;
      ChangedVoxels changed{edited->second, {}};
      if (since < edited->second) changed.voxels.push_back({1, MaterialId{7}});
      return changed;
    };
  }
  void edit(ChunkKey key, std::uint64_t revision) { source.revisions[key] = revision; }
  void tell(ChunkKey key, std::uint64_t previous, std::uint64_t revision) {
    mailbox->put_changes(
        std::make_shared<const std::vector<ChunkChange>>(1, ChunkChange{key, previous, revision}));
    take_mail();
  }
};

std::vector<ChunkKey> keys(const std::vector<SessionFrame>& said) {
  std::vector<ChunkKey> keys;
  for (const SessionFrame& each : said) keys.push_back(each.key);
  return keys;
}

}  // namespace

TEST_CASE("a View with a base brings its edited chunks as broadcasts, nearest first, and is complete then") {
  Bench bench;
  bench.edit(chunk_at(2), 4);
  bench.edit(chunk_at(0), 3);
  bench.edit(chunk_at(9), 5);  // outside
  bench.view_number = 6;
  bench.move_view(0, 2);
  auto said = bench.output();
  CHECK(kinds(said) == Kinds{Body::EditBroadcast, Body::EditBroadcast});
  CHECK(keys(said) == std::vector{chunk_at(0), chunk_at(2)});
  for (const SessionFrame& each : said) CHECK(each.previous_revision == 0);
  CHECK(said.at(0).revision == 3);
  CHECK(said.at(0).voxels == std::vector<Override>{{1, MaterialId{7}}});
  said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::ViewComplete});
  CHECK(said[0].view_number == 6);
  CHECK(bench.source.submitted == 0);  // nothing is generated
}

TEST_CASE("a View with a base and without edits is complete at once, though its columns are known") {
  Bench bench;
  bench.source.rows = {0, -1, MaterialId{2}};
  bench.view_number = 1;
  bench.move_view(0, 3, 2);
  CHECK(kinds(bench.output()) == Kinds{Body::ViewComplete});
  CHECK(bench.source.submitted == 0);
}

TEST_CASE("without credit a View with a base gets no UniformColumn") {
  Bench bench;
  bench.limits.window_bytes = 1;
  bench.source.rows = {0, -1, MaterialId{2}};
  bench.source.in_memory[chunk_at(0)] = scripted_chunk(chunk_at(0));
  bench.has_base = false;
  bench.get_chunk(1, chunk_at(0));
  CHECK(kinds(bench.output()) == Kinds{Body::Chunk});
  bench.has_base = true;
  bench.edit(chunk_at(1), 2);
  bench.move_view(0, 1);
  for (const SessionFrame& each : bench.output()) CHECK(each.kind != Body::UniformColumn);
}

TEST_CASE("an edited chunk whose changes are not remembered is made, alone, and comes whole") {
  Bench bench{false};
  bench.source.together = 4;
  bench.edit(chunk_at(1), 3);
  bench.view_number = 2;
  bench.move_view(0, 3);
  CHECK(bench.output().empty());
  CHECK(bench.source.submissions == std::vector<std::vector<ChunkKey>>{{chunk_at(1)}});
  bench.source.in_memory[chunk_at(1)] = scripted_chunk(chunk_at(1), 3);
  bench.answer_all();
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Chunk});
  CHECK(said[0].revision == 3);
  CHECK(kinds(bench.output()) == Kinds{Body::ViewComplete});
}

TEST_CASE(
    "edited chunks of a View with a base are wanted soon if they are near or come near, and if edited "
    "again") {
  Bench bench{false};
  bench.edit(chunk_at(1), 3);
  bench.edit(chunk_at(3), 3);
  bench.move_view(0, 3);
  (void)bench.output();
  REQUIRE(bench.source.waiting.size() == 2);
  CHECK(bench.source.wanted_soon == std::set{chunk_at(1)});
  bench.move_view(2, 3);
  CHECK(bench.source.wanted_soon.contains(chunk_at(3)));
  for (const ChunkKey key : {chunk_at(1), chunk_at(3)}) bench.source.in_memory[key] = scripted_chunk(key, 3);
  bench.answer_all();
  (void)bench.output();
  bench.source.wanted_soon.clear();
  bench.edit(chunk_at(5), 4);
  bench.tell(chunk_at(5), 0, 4);  // far, and not the first that the View sends
  (void)bench.output();
  CHECK(bench.source.wanted_soon.contains(chunk_at(5)));
}

TEST_CASE("a chunk of a View with a base that cannot be made is given up, and the View is complete") {
  Bench bench{false};
  bench.edit(chunk_at(1), 3);
  bench.view_number = 2;
  bench.move_view(0, 3);
  (void)bench.output();
  bench.source.fail(chunk_at(1));
  bench.take_mail();
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Error, Body::ViewComplete});
  CHECK(said[0].about == wire::ErrorAbout::view_chunk);
}

TEST_CASE("a client that holds an edited chunk is told that it is unchanged, or sent it") {
  const bool right = GENERATE(true, false);
  Bench bench;
  const ChunkKey key = chunk_at(1);
  bench.edit(key, 3);
  bench.source.in_memory[key] = scripted_chunk(key, 3);
  bench.say_view(0, 3, 0, {scripted_chunk(key, right ? 3 : 2)}, {key});
  bench.apply_view();
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{right ? Body::Unchanged : Body::Chunk});
  CHECK(said[0].key == key);
}

TEST_CASE("an edit of a chunk that the client made is broadcast to it") {
  Bench bench;
  bench.move_view(0, 2);
  CHECK(bench.output().empty());
  bench.edit(chunk_at(1), 3);
  bench.tell(chunk_at(1), 0, 3);
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::EditBroadcast});
  CHECK(said[0].previous_revision == 0);
  CHECK(said[0].revision == 3);
}

TEST_CASE("an edit that is reported after it was found comes once") {
  Bench bench;
  bench.edit(chunk_at(1), 3);
  bench.move_view(0, 2);
  bench.tell(chunk_at(1), 0, 3);
  CHECK(kinds(bench.output()) == Kinds{Body::EditBroadcast});
  CHECK(bench.output().empty());
}

TEST_CASE("a View with a base that moves on brings only what came in, and looks for edits only there") {
  Bench bench;
  for (int x = 0; x < 8; ++x) bench.edit(chunk_at(x), 3);
  bench.move_view(2, 2);
  CHECK(bench.output().size() == 5);
  bench.source.looked_into.clear();
  bench.move_view(3, 2);
  CHECK(keys(bench.output()) == std::vector{chunk_at(5)});
  CHECK(bench.source.looked_into == std::vector{chunk_at(5)});
  bench.move_view(2, 2);  // a chunk that comes back is sent again
  CHECK(keys(bench.output()) == std::vector{chunk_at(0)});
}

TEST_CASE("what a View with a base does not want any more is neither sent nor made") {
  Bench bench{false};
  bench.edit(chunk_at(1), 3);
  bench.edit(chunk_at(2), 3);
  bench.view_number = 1;
  bench.move_view(0, 1);
  (void)bench.output();
  CHECK(bench.source.waiting.contains(chunk_at(1)));
  bench.view_number = 2;
  bench.move_view(100, 1);
  CHECK(bench.source.waiting.empty());
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::ViewComplete});
  CHECK(said[0].view_number == 2);
}

TEST_CASE("many edited chunks come in the end, however few wait at once") {
  Bench bench{GENERATE(true, false)};
  std::size_t edited = 0;
  for (std::int32_t x = -10; x <= 10; ++x) {
    for (std::int32_t z = -10; z <= 10; ++z, ++edited) {
      bench.edit(chunk_at(x, 0, z), 3);
      if (bench.source.changes == nullptr) {
        bench.source.in_memory[chunk_at(x, 0, z)] = scripted_chunk(chunk_at(x, 0, z), 3, 5'000);
      }
    }
  }
  bench.view_number = 1;
  bench.move_view(0, 10);
  std::vector<SessionFrame> said = bench.output(5000);
  CHECK(said.size() < edited);
  // A write may be empty that finds an update to be a whole chunk, which goes in another turn.
  for (int empty = 0; empty < 3;) {
    const auto more = bench.output(5000);
    empty = more.empty() ? empty + 1 : 0;
    said.insert(said.end(), more.begin(), more.end());
  }
  CHECK(said.size() == edited + 1);
  CHECK(said.back().kind == Body::ViewComplete);
}

TEST_CASE("a client that sends no more gets the edited chunks of its View before the end") {
  Bench bench{false};
  bench.edit(chunk_at(1), 3);
  bench.move_view(0, 1);
  (void)bench.output();
  bench.session.input_ended();
  CHECK_FALSE(bench.session.closing());
  bench.source.in_memory[chunk_at(1)] = scripted_chunk(chunk_at(1), 3);
  bench.answer_all();
  CHECK(kinds(bench.output()) == Kinds{Body::Chunk});
  CHECK(bench.session.closing());
}

TEST_CASE("a View with a base is refused where the world is not published, and the View before stays") {
  SessionBench bench;
  bench.source.in_memory[chunk_at(0)] = scripted_chunk(chunk_at(0));
  bench.move_view(0, 0);
  CHECK(kinds(bench.output()) == Kinds{Body::Chunk});
  bench.has_base = true;
  bench.view_number = 3;
  bench.move_view(5, 0);
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Error});
  CHECK(said[0].code == wire::ErrorCode::unsupported);
  CHECK(said[0].about == wire::ErrorAbout::view);
  CHECK(said[0].view_number == 3);
  CHECK_FALSE(bench.session.view_waits());
}

TEST_CASE("a client that begins to make chunks is sent what is edited of those that it was not sent") {
  Bench bench;
  bench.has_base = false;
  bench.edit(chunk_at(-1), 3);
  bench.edit(chunk_at(1), 3);
  bench.source.in_memory[chunk_at(0)] = scripted_chunk(chunk_at(0));
  bench.source.in_memory[chunk_at(-1)] = scripted_chunk(chunk_at(-1), 3);
  bench.move_view(0, 2);
  CHECK(bench.output().size() == 2);
  CHECK(bench.source.wants_chunks);
  CHECK(bench.source.waiting.size() == 23);
  bench.has_base = true;
  bench.move_view(0, 2);
  CHECK(bench.source.waiting.empty());
  CHECK_FALSE(bench.source.wants_chunks);
  const auto said = bench.output();
  CHECK(kinds(said) == Kinds{Body::EditBroadcast});
  CHECK(keys(said) == std::vector{chunk_at(1)});
  // What was streamed is up to date as before.
  bench.edit(chunk_at(0), 4);
  bench.tell(chunk_at(0), 0, 4);
  CHECK(keys(bench.output()) == std::vector{chunk_at(0)});
}

TEST_CASE("a chunk in the queue is dropped if the client begins to make chunks") {
  Bench bench;
  bench.has_base = false;
  for (int x = -2; x <= 2; ++x) bench.source.in_memory[chunk_at(x)] = scripted_chunk(chunk_at(x));
  bench.move_view(0, 2);
  bench.has_base = true;
  bench.move_view(0, 2);
  CHECK(bench.output().empty());
}

TEST_CASE("a client that makes chunks no more is sent every chunk, whatever came before") {
  const bool skipped = GENERATE(false, true);  // the server applies only the last of its Views
  Bench bench;
  bench.edit(chunk_at(1), 3);
  bench.move_view(0, 1);
  CHECK(bench.output().size() == 1);
  bench.has_base = false;
  if (skipped) {
    bench.say_view(0, 1);
    bench.has_base = true;
    bench.move_view(0, 1);
    CHECK(keys(bench.output()) == std::vector{chunk_at(1)});
    return;
  }
  for (int x = -1; x <= 1; ++x)
    bench.source.in_memory[chunk_at(x)] = scripted_chunk(chunk_at(x), x == 1 ? 3 : 0);
  bench.view_number = 2;
  bench.move_view(0, 1);
  const auto said = bench.run_dry();
  CHECK(said.size() == 10);
  CHECK(std::ranges::count(kinds(said), Body::Chunk) == 9);
  CHECK(said.back().kind == Body::ViewComplete);
  CHECK(bench.source.wants_chunks);
}

TEST_CASE("the metrics count Views by what is sent for them") {
  Bench bench;
  const auto views = [&] {
    return std::pair{bench.metrics.views_local.now(), bench.metrics.views_stream.now()};
  };
  CHECK(views() == std::pair<std::int64_t, std::int64_t>{0, 0});
  bench.move_view(0, 1);
  bench.move_view(1, 1);
  CHECK(views() == std::pair<std::int64_t, std::int64_t>{1, 0});
  bench.has_base = false;
  bench.move_view(0, 1);
  CHECK(views() == std::pair<std::int64_t, std::int64_t>{0, 1});
  bench.session.abandon();
  CHECK(views() == std::pair<std::int64_t, std::int64_t>{0, 0});
}

TEST_CASE("a generated chunk that a client makes otherwise is a failed proof") {
  Bench bench;
  bench.source.in_memory[chunk_at(0)] = scripted_chunk(chunk_at(0));
  bench.source.in_memory[chunk_at(1)] = scripted_chunk(chunk_at(1), 3);
  const EncodedChunkPtr wrong = scripted_chunk(chunk_at(7));
  bench.get_chunk(1, chunk_at(0), wrong);  // before its View
  CHECK(bench.metrics.proofs_failed.total() == 0);
  bench.move_view(0, 1);
  bench.get_chunk(2, chunk_at(0), scripted_chunk(chunk_at(0)));
  bench.get_chunk(3, chunk_at(1), wrong);  // it was edited
  bench.get_chunk(4, chunk_at(0));
  CHECK(bench.metrics.proofs_failed.total() == 0);
  bench.get_chunk(5, chunk_at(0), wrong);
  CHECK(bench.metrics.proofs_failed.total() == 1);
}
