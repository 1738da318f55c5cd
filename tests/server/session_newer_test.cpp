// A chunk that waits to be written is replaced by a newer version that is in memory.
#include <catch2/catch.hpp>

#include "session_bench.h"

using namespace talus;
using namespace talus::server;
using Body = wire::Body;

namespace {

const ChunkKey kKey = chunk_at(5);

/// A session in whose outbox revision 1 of kKey waits: for request 1, or for the View.
struct OutboxBench : SessionBench {
  explicit OutboxBench(bool for_view, const EncodedChunkPtr& known = nullptr) {
    source.in_memory[kKey] = scripted_chunk(kKey, 1);
    if (for_view) {
      const std::vector<EncodedChunkPtr> held(known == nullptr ? 0 : 1, known);
      say_view(5, 0, 0, held, {kKey});
      apply_view();
    } else {
      get_chunk(1, kKey, known);
    }
  }
};

}  // namespace

TEST_CASE("the older version is never written once the newer is in memory") {
  const bool for_view = GENERATE(true, false);
  OutboxBench bench{for_view};
  bench.source.in_memory[kKey] = scripted_chunk(kKey, 2, 5000);
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Chunk});
  CHECK(said[0].revision == 2);
  CHECK(said[0].id == (for_view ? 0 : 1));
}

TEST_CASE("a version that came by mail is replaced as well") {
  SessionBench bench;
  bench.get_chunk(1, kKey);
  bench.source.mail(kKey, scripted_chunk(kKey, 1));
  bench.source.in_memory[kKey] = scripted_chunk(kKey, 2);
  bench.take_mail();
  CHECK(bench.output().at(0).revision == 2);
}

TEST_CASE("a newer version that the client holds is confirmed instead of sent") {
  const bool for_view = GENERATE(true, false);
  OutboxBench bench{for_view, scripted_chunk(kKey, 2)};
  bench.source.in_memory[kKey] = scripted_chunk(kKey, 2);
  const auto said = bench.output();
  REQUIRE(kinds(said) == Kinds{Body::Unchanged});
  CHECK(said[0].revision == 2);
  CHECK(said[0].id == (for_view ? 0 : 1));
  CHECK(bench.output().empty());
}

TEST_CASE("a replaced chunk is answered once") {
  const bool for_view = GENERATE(true, false);
  OutboxBench bench{for_view};
  bench.source.in_memory[kKey] = scripted_chunk(kKey, 2);
  CHECK(bench.run_dry().size() == 1);
  CHECK(bench.run_dry().empty());
}

TEST_CASE("credit counts the version that was written") {
  OutboxBench bench{false};
  bench.source.in_memory[kKey] = scripted_chunk(kKey, 2, 5000);
  const std::size_t bytes = bench.output().at(0).frame_bytes;
  bench.credit(bytes);
  CHECK(bench.session.state() == Session::State::joined);
  bench.credit(bytes + 1);
  CHECK(bench.session.state() == Session::State::closed);
}

TEST_CASE("the memory of a replaced chunk is given back") {
  OutboxBench bench{false};
  bench.source.in_memory[kKey] = scripted_chunk(kKey, 2, 200'000);
  (void)bench.output();
  CHECK(bench.memory.used(MemoryUse::sessions) <= Session::kIdleBytes + 4096);
}

TEST_CASE("a source is asked for the newest revision once a chunk written") {
  SessionBench bench;
  bench.move_view(0, 3);
  CHECK(bench.run_dry().size() == 49);
  CHECK(bench.source.revisions_asked == 49);
}
