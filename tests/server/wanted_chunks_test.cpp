#include "chunks/generation/wanted_chunks.h"

#include <rapidcheck.h>
#include <catch2/catch.hpp>
#include <map>

#include "failing_allocations.h"

using namespace talus;
using namespace talus::server;

namespace {

constexpr ChunkRange kAllRows{INT32_MIN, INT32_MAX};

ChunkRange range(std::int64_t first, std::int64_t size) {
  return {first, first + size - 1};
}

LevelBox box(int level, ChunkRange x, ChunkRange y, ChunkRange z) {
  return {Lod::of(level), x, y, z, {}, {}};
}

/// Boxes of a few chunks or of many, beside the world's middle or one of its ends, so that some share cells.
LevelBox random_box() {
  const int level = *rc::gen::inRange(0, 3);
  const std::int64_t limit = chunk_limit(Lod::of(level));
  const auto axis = [&] {
    const std::int64_t size =
        *rc::gen::oneOf(rc::gen::inRange<std::int64_t>(0, 6), rc::gen::inRange<std::int64_t>(6, 400));
    const std::int64_t middle = *rc::gen::element<std::int64_t>(-limit, 0, limit - size);
    const std::int64_t first = middle + *rc::gen::inRange<std::int64_t>(-8, 9);
    return ChunkRange{std::max(first, -limit), std::min(first + size, limit) - 1};
  };
  LevelBox made{Lod::of(level), axis(), range(*rc::gen::inRange(-3, 3), *rc::gen::inRange(0, 4)),
                axis(),         {},     {}};
  if (*rc::gen::arbitrary<bool>()) {
    made.inner_x = {made.x.first + 1, made.x.last - 1};
    made.inner_z = {made.z.first + 1, made.z.last - 1};
  }
  return made;
}

ChunkRange hull(const std::map<int, std::vector<LevelBox>>& clients, ChunkKey column, ChunkRange rows) {
  ChunkRange hull;
  for (const auto& [client, boxes] : clients) {
    for (const LevelBox& each : boxes) {
      const ChunkRange shared = overlap(rows, each.y);
      if (each.lod != column.lod || !each.has_column(column.coord.x, column.coord.z) || shared.size() == 0)
        continue;
      hull = hull.size() == 0
                 ? shared
                 : ChunkRange{std::min(hull.first, shared.first), std::max(hull.last, shared.last)};
    }
  }
  return hull;
}

}  // namespace

TEST_CASE("a column's rows are the union of all clients' boxes") {
  CHECK(rc::check([] {
    WantedChunks wanted;
    std::map<int, std::vector<LevelBox>> clients;
    const int steps = *rc::gen::inRange(1, 12);
    for (int step = 0; step < steps; ++step) {
      const int client = *rc::gen::inRange(0, 4);
      // Now and then those of another client.
      std::vector<LevelBox> boxes = clients[*rc::gen::inRange(0, 4)];
      if (*rc::gen::arbitrary<bool>()) boxes.clear();
      for (int i = *rc::gen::inRange(0, 3); i > 0; --i) boxes.push_back(random_box());
      wanted.set(ClientId{static_cast<std::uint64_t>(client)}, boxes);
      clients[client] = boxes;
    }
    for (const auto& [client, boxes] : clients) {
      for (const LevelBox& each : boxes) {
        const auto beside = [&](ChunkRange of) {
          const std::int64_t at = *rc::gen::element<std::int64_t>(
              of.first - 1, of.first, (of.first + of.last) / 2, of.last, of.last + 1);
          const std::int64_t limit = chunk_limit(each.lod);
          return static_cast<std::int32_t>(std::clamp(at, -limit, limit - 1));
        };
        const ChunkKey column{{beside(each.x), 0, beside(each.z)}, each.lod};
        const ChunkRange rows = range(*rc::gen::inRange(-4, 4), *rc::gen::inRange(0, 6));
        const ChunkRange found = wanted.rows_of(column, rows);
        const ChunkRange expected = hull(clients, column, rows);
        RC_ASSERT(found.size() == expected.size());
        RC_ASSERT(wanted.has_column(column) == (hull(clients, column, kAllRows).size() > 0));
        if (expected.size() > 0) RC_ASSERT(found == expected);
      }
    }
  }));
}

TEST_CASE("a client without boxes wants nothing") {
  WantedChunks wanted;
  wanted.set(ClientId{1}, std::array{box(0, range(0, 4), range(0, 2), range(0, 4))});
  wanted.set(ClientId{2}, std::array{box(0, range(2, 4), range(0, 2), range(0, 4))});
  const ChunkKey shared{{3, 0, 3}, Lod{}};
  CHECK(wanted.rows_of(shared, kAllRows) == ChunkRange{0, 1});
  wanted.set(ClientId{1}, {});
  CHECK(wanted.rows_of(shared, kAllRows) == ChunkRange{0, 1});
  CHECK(wanted.rows_of({{1, 0, 3}, Lod{}}, kAllRows).size() == 0);
  wanted.set(ClientId{2}, {});
  CHECK(wanted.rows_of(shared, kAllRows).size() == 0);
  CHECK(wanted.empty());
}

TEST_CASE("if any allocation fails while boxes are set, the client has no boxes, and others keep theirs") {
  bool failed = true;
  for (std::size_t allocations = 0; failed; ++allocations) {
    CAPTURE(allocations);
    WantedChunks wanted;
    const std::array boxes{box(0, range(0, 4), range(0, 2), range(0, 4)),
                           box(2, range(-9, 4), range(0, 2), range(0, 4))};
    // One of them is the other client's too.
    const std::array others{boxes[0], box(1, range(-9, 4), range(0, 2), range(0, 4))};
    wanted.set(ClientId{1}, boxes);
    try {
      const talus::test::FailingAllocations failing{allocations};
      wanted.set(ClientId{2}, others);
      failed = failing.has_failed();
    } catch (const std::bad_alloc&) {
      CHECK(wanted.rows_of({{1, 0, 1}, Lod{}}, kAllRows) == ChunkRange{0, 1});
      wanted.set(ClientId{1}, {});
      CHECK(wanted.empty());
      continue;
    }
    wanted.set(ClientId{1}, {});
    CHECK(wanted.rows_of({{1, 0, 1}, Lod{}}, kAllRows) == ChunkRange{0, 1});
  }
}
