#include "held_revisions.h"

#include <catch2/catch.hpp>

using namespace talus;
using namespace talus::load;

namespace {

constexpr ChunkKey kChunk{{1, 2, 3}, Lod{}};
constexpr ChunkKey kOther{{1, 2, 4}, Lod{}};

}  // namespace

TEST_CASE("a chunk of a higher revision is new, the same or an older revision is not") {
  HeldRevisions held;
  CHECK_FALSE(held.raise(kChunk, 0));
  CHECK(held.raise(kChunk, 5));
  CHECK_FALSE(held.raise(kChunk, 5));
  CHECK_FALSE(held.raise(kChunk, 4));
  CHECK(held.raise(kChunk, 6));
  CHECK(held.raise(kOther, 1));
}

TEST_CASE("a chunk that left the View holds no revision") {
  HeldRevisions held;
  (void)held.raise(kChunk, 5);
  (void)held.raise(kOther, 5);
  held.forget([](const ChunkKey& key) { return key == kChunk; });
  CHECK(held.size() == 1);
  CHECK(held.raise(kChunk, 5));
  CHECK_FALSE(held.raise(kOther, 5));
}
