#include <talus/client/chunk_store.h>

#include <catch2/catch.hpp>

#include "peer.h"

using namespace talus;
using namespace talus::client;
using namespace talus::client::testing;

namespace {

ReceivedChunk revision(std::uint64_t number) {
  const ChunkKey key = key_at(0, 0, 0);
  return {key, number, {number, 0}, std::make_shared<const Chunk>(some_chunk(key))};
}

}  // namespace

TEST_CASE("a store holds the newest revision, in whatever order they come") {
  ChunkStore store{1 << 20};
  for (const std::uint64_t number : {3U, 5U, 4U}) store.put(revision(number));
  REQUIRE(store.look(key_at(0, 0, 0)) != nullptr);
  CHECK(store.look(key_at(0, 0, 0))->revision == 5);
  CHECK(store.size() == 1);
}

TEST_CASE("a cleared store is empty, and takes any revision again") {
  ChunkStore store{1 << 20};
  store.put(revision(5));
  store.clear();
  CHECK(store.size() == 0);
  CHECK(store.bytes() == 0);
  CHECK(store.find(key_at(0, 0, 0)) == nullptr);
  store.put(revision(1));
  CHECK(store.look(key_at(0, 0, 0))->revision == 1);
}
