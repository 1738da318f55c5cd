#include "player/view/heading.h"

#include <catch2/catch.hpp>

using namespace talus;
using namespace talus::server;

namespace {

/// Seventeen chunks wide around the centre.
std::vector<LevelBox> around(std::int64_t x, std::int64_t z) {
  return {{Lod{}, {x - 8, x + 8}, {0, 1}, {z - 8, z + 8}, {}, {}}};
}

}  // namespace

TEST_CASE("a View that never moved has nothing ahead of it, wherever it is") {
  for (const std::int64_t x : {3, 1000}) {
    Heading heading;
    heading.move_to({x, 0, 2}, 8);
    CHECK(heading.ahead(around(x, 2)) == around(x, 2));
  }
}

TEST_CASE("chunks that a ring will reach lie ahead of it, including those that the finer level leaves") {
  Heading heading;
  heading.move_to({0, 0, 0}, 64);
  heading.move_to({12, 0, -1}, 64);
  const LevelBox ring{Lod::of(1), {-26, 38}, {0, 1}, {-33, 31}, {2, 9}, {-5, 3}};
  const LevelBox ahead = heading.ahead({ring}).front();
  CHECK(ahead.x == ChunkRange{-26, 38 + Heading::kAhead});
  CHECK(ahead.z == ChunkRange{-33 - Heading::kAhead, 31});
  CHECK(ahead.inner_x == ChunkRange{2 + Heading::kAhead, 9});
  CHECK(ahead.inner_z == ChunkRange{-5, 3 - Heading::kAhead});
}

TEST_CASE("a View has more ahead of it in its direction, and no less behind") {
  Heading heading;
  heading.move_to({0, 0, 0}, 8);
  heading.move_to({1, 0, 0}, 8);
  CHECK(heading.ahead(around(1, 0)).front().x == ChunkRange{-7, 9 + Heading::kAhead});
  CHECK(heading.ahead(around(1, 0)).front().z == ChunkRange{-8, 8});
  CHECK(heading.ahead(around(1, 0)).front().y == ChunkRange{0, 1});
  // Back again: what it did last counts most.
  heading.move_to({-2, 0, 0}, 8);
  CHECK(heading.ahead(around(-2, 0)).front().x == ChunkRange{-10 - Heading::kAhead, 6});
}

TEST_CASE("a View that moves aslant keeps both directions between its steps") {
  Heading heading;
  std::int64_t z = 0;
  for (std::int64_t x = 0; x < 40; ++x) {
    if (x % 4 == 0) --z;
    heading.move_to({x, 0, z}, 8);
    if (x < 8) continue;
    CHECK(heading.ahead(around(x, z)).front().x.last == x + 8 + Heading::kAhead);
    CHECK(heading.ahead(around(x, z)).front().z.first == z - 8 - Heading::kAhead);
  }
}

TEST_CASE("a View that stands or rises keeps its heading; after a jump it has no heading") {
  Heading heading;
  heading.move_to({0, 0, 0}, 8);
  heading.move_to({0, 0, 1}, 8);
  heading.move_to({0, 7, 1}, 8);
  heading.move_to({0, 7, 1}, 8);
  CHECK(heading.ahead(around(0, 1)).front().z.last == 9 + Heading::kAhead);
  heading.move_to({0, 7, 500}, 8);
  CHECK(heading.ahead(around(0, 500)).front().z == ChunkRange{492, 508});
}

TEST_CASE("the area ahead ends at the world's edge") {
  constexpr std::int64_t kEnd = std::int64_t{1} << 31;
  Heading heading;
  heading.move_to({kEnd - 4, 0, 0}, 8);
  heading.move_to({kEnd - 3, 0, 0}, 8);
  const std::vector<LevelBox> boxes{{Lod{}, {kEnd - 11, kEnd - 1}, {0, 1}, {-8, 8}, {}, {}}};
  CHECK(heading.ahead(boxes).front().x == ChunkRange{kEnd - 11, kEnd - 1});
}
