#include "view_tracker.h"

#include <catch2/catch.hpp>

#include "peer.h"

using namespace talus;
using namespace talus::client;
using namespace talus::client::testing;

namespace {

View around(int chunk_x) {
  return {{chunk_x * kChunkSize, 0, 0}, {}, 1, 0, {}};
}

ReceivedChunk chunk_at(int x, std::uint64_t revision = 0) {
  const ChunkKey key = key_at(x, 0, 0);
  return {key, revision, {static_cast<std::uint64_t>(x), 1}, std::make_shared<const Chunk>(some_chunk(key))};
}

}  // namespace

TEST_CASE("chunks that leave the View are reported, chunks that stay are not") {
  ViewTracker tracker{1 << 20};
  CHECK(tracker.replace(around(0)).empty());
  for (const int x : {-1, 0, 1}) REQUIRE(tracker.deliver(chunk_at(x)));
  CHECK(tracker.replace(around(1)) == std::vector{key_at(-1, 0, 0)});
  CHECK(tracker.was_delivered(key_at(0, 0, 0)));
  CHECK_FALSE(tracker.was_delivered(key_at(-1, 0, 0)));
  CHECK(tracker.replace(around(9)).size() == 2);
}

TEST_CASE("a chunk that left is held where the caller still had it, and known when its View comes back") {
  ViewTracker tracker{1 << 20};
  (void)tracker.replace(around(0));
  const ReceivedChunk held = chunk_at(-1);
  REQUIRE(tracker.deliver(held));
  REQUIRE(tracker.deliver(chunk_at(0)));  // nobody keeps it
  (void)tracker.replace(around(9));
  CHECK(tracker.held(key_at(-1, 0, 0)));
  CHECK_FALSE(tracker.held(key_at(0, 0, 0)));
  CHECK(tracker.known(10, false).empty());
  (void)tracker.replace(around(0));
  const auto known = tracker.known(10, false);
  REQUIRE(known.size() == 1);
  CHECK(known[0].hash == held.hash);
  CHECK(tracker.known(0, false).empty());
}

TEST_CASE("a tracker of no bytes keeps nothing") {
  ViewTracker tracker{0};
  (void)tracker.replace(around(0));
  const ReceivedChunk held = chunk_at(0);
  REQUIRE(tracker.deliver(held));
  (void)tracker.replace(around(9));
  CHECK_FALSE(tracker.held(held.key));
}

TEST_CASE("chunks of one material are not known: they cost nothing to send") {
  ViewTracker tracker{1 << 20};
  (void)tracker.replace(around(0));
  const ReceivedChunk uniform{key_at(0, 0, 0), 0, {}, std::make_shared<const Chunk>(Chunk::uniform(kAir))};
  REQUIRE(tracker.deliver(uniform));
  CHECK(tracker.known(10, true).empty());
}

TEST_CASE("on a new connection delivered chunks count as known") {
  ViewTracker tracker{1 << 20};
  (void)tracker.replace(around(0));
  const ReceivedChunk held = chunk_at(0);
  REQUIRE(tracker.deliver(held));
  CHECK(tracker.known(10, false).empty());
  CHECK(tracker.known(10, true).size() == 1);
}

TEST_CASE("an older revision never replaces a newer one, until the store changes") {
  ViewTracker tracker{1 << 20};
  (void)tracker.replace(around(0));
  REQUIRE(tracker.deliver(chunk_at(0, 5)));
  CHECK_FALSE(tracker.deliver(chunk_at(0, 4)));
  CHECK(tracker.deliver(chunk_at(0, 5)));
  CHECK(tracker.deliver(chunk_at(0, 6)));
  tracker.forget_revisions();
  CHECK(tracker.deliver(chunk_at(0, 1)));
}
