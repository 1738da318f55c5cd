#include "pending_rings.h"

#include <catch2/catch.hpp>

using namespace talus;
using namespace talus::load;
using Verdict = PendingChunks::Verdict;

namespace {

constexpr HeightRange kHeights{0, 200};  // rows -1 to 3 of level 1

client::ViewShape shape_at(std::int64_t chunk_x) {
  client::View view{{chunk_x * kChunkSize, 0, 0}, {}, 1, 0, {{Lod::of(1), 3}}};
  view.horizon = true;
  return client::ViewShape{view, kHeights};
}

ChunkKey ring(std::int32_t x, std::int32_t y) {
  return {{x, y, 0}, Lod::of(1)};
}

constexpr std::size_t kAll = 4 * 4 * 5;

}  // namespace

TEST_CASE("a ring's chunks come once each, from the lowest row to the highest") {
  PendingRings pending;
  pending.move_to(shape_at(0));
  CHECK(pending.waiting() == kAll);
  CHECK(pending.arrive(ring(0, 3)) == Verdict::came);
  CHECK(pending.arrive(ring(0, -1)) == Verdict::came);
  CHECK(pending.arrive(ring(0, 3)) == Verdict::duplicate);
  CHECK(pending.arrive(ring(0, 4)) == Verdict::outside);
  CHECK(pending.arrive(ring(3, 0)) == Verdict::outside);
  CHECK(pending.waiting() == kAll - 2);
}

TEST_CASE("a chunk that a ring left may come late, and again when the ring returns, but need not") {
  PendingRings pending;
  pending.move_to(shape_at(0));
  CHECK(pending.arrive(ring(-2, 0)) == Verdict::came);
  pending.move_to(shape_at(2));
  CHECK(pending.waiting() == kAll);
  CHECK(pending.arrive(ring(-2, 1)) == Verdict::stale);
  pending.move_to(shape_at(0));
  CHECK(pending.waiting() == kAll - 4 * 5);
  CHECK(pending.arrive(ring(-2, 0)) == Verdict::came);
  CHECK(pending.arrive(ring(-2, 0)) == Verdict::repeated);
  CHECK(pending.waiting() == kAll - 4 * 5);
}

TEST_CASE("a chunk that stays in a ring stays held") {
  PendingRings pending;
  pending.move_to(shape_at(0));
  CHECK(pending.arrive(ring(1, 2)) == Verdict::came);
  pending.move_to(shape_at(2));
  CHECK(pending.arrive(ring(1, 2)) == Verdict::duplicate);
}
