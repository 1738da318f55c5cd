#include "pending_chunks.h"

#include <rapidcheck/catch.h>
#include <catch2/catch.hpp>

using namespace talus;
using namespace talus::load;
using std::chrono::milliseconds;
using std::chrono::seconds;
using Verdict = PendingChunks::Verdict;

namespace {

const Time kStart = Time{} + seconds{1000};

std::vector<PendingChunks::MissedChunk> go(PendingChunks& pending, std::int64_t x, Clock::duration at,
                                           int radius = 2) {
  const glm::i64vec3 centre{x, 0, 0};
  return pending.move_to(box_around(centre, radius, 1), centre, kStart + at, kStart + at);
}

std::size_t take_all(PendingChunks& pending) {
  std::size_t came = 0;
  const Box box = pending.box();
  for (std::int64_t x = box.low.x; x <= box.high.x; ++x) {
    for (std::int64_t y = box.low.y; y <= box.high.y; ++y) {
      for (std::int64_t z = box.low.z; z <= box.high.z; ++z) {
        const ChunkCoord chunk{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y),
                               static_cast<std::int32_t>(z)};
        if (pending.arrive(chunk).verdict == Verdict::came) ++came;
      }
    }
  }
  return came;
}

constexpr std::size_t kAll = 5 * 3 * 5;
constexpr std::size_t kSlice = 3 * 5;

}  // namespace

TEST_CASE("a chunk's wait begins with the View that first wanted it") {
  PendingChunks pending;
  (void)go(pending, 0, milliseconds{0});
  (void)go(pending, 1, milliseconds{500});
  const auto old = pending.arrive({0, 0, 0});
  CHECK(old.since == kStart);
  CHECK(old.steps_late == 1);
  CHECK(old.join);
  const auto fresh = pending.arrive({3, 0, 0});
  CHECK(fresh.since == kStart + milliseconds{500});
  CHECK(fresh.steps_late == 0);
  CHECK_FALSE(fresh.join);
}

TEST_CASE("boxes meet where they have a chunk in common") {
  const Box box{{0, 0, 0}, {4, 2, 4}};
  for (const glm::i64vec3& by : {glm::i64vec3{4, 0, 0}, {0, 2, 0}, {0, 0, -4}, {-4, -2, 4}, {0, 0, 0}}) {
    CHECK(box.meets({box.low + by, box.high + by}));
  }
  for (const glm::i64vec3& by : {glm::i64vec3{5, 0, 0}, {0, 3, 0}, {0, 0, -5}, {-5, -2, 4}}) {
    CHECK_FALSE(box.meets({box.low + by, box.high + by}));
  }
  CHECK_FALSE(box.meets({}));
}

TEST_CASE("a chunk of a View is right after its program was stopped, and has caught up") {
  PendingChunks pending;
  (void)go(pending, 0, {});
  const Time now = kStart + seconds{100};
  for (int x = 1; x <= 100; ++x) {
    const glm::i64vec3 centre{x, 0, 0};
    (void)pending.move_to(box_around(centre, 2, 1), centre, kStart + seconds{x}, now);
  }
  CHECK(pending.arrive({0, 0, 0}).verdict == Verdict::stale);
  CHECK(pending.arrive({102, 0, 0}).verdict == Verdict::came);
  (void)go(pending, 101, seconds{119});
  CHECK(pending.arrive({0, 1, 0}).verdict == Verdict::stale);
  (void)go(pending, 102, seconds{121});
  CHECK(pending.arrive({0, 1, 1}).verdict == Verdict::outside);
}

TEST_CASE("a chunk comes once") {
  PendingChunks pending;
  (void)go(pending, 0, {});
  CHECK(pending.arrive({1, 1, 1}).verdict == Verdict::came);
  CHECK(pending.arrive({1, 1, 1}).verdict == Verdict::duplicate);
}

TEST_CASE("a chunk that stays in the View is not pending again") {
  PendingChunks pending;
  (void)go(pending, 0, {});
  CHECK(take_all(pending) == kAll);
  (void)go(pending, 1, seconds{1});
  CHECK(pending.waiting() == kSlice);
  CHECK(pending.arrive({0, 0, 0}).verdict == Verdict::duplicate);
}

TEST_CASE("a chunk never requested is outside; a chunk that just left is only late") {
  PendingChunks pending;
  (void)go(pending, 0, {});
  (void)go(pending, 1, seconds{1});
  CHECK(pending.arrive({-2, 0, 0}).verdict == Verdict::stale);
  CHECK(pending.arrive({-3, 0, 0}).verdict == Verdict::outside);
  CHECK(pending.arrive({0, 2, 0}).verdict == Verdict::outside);
}

TEST_CASE("a chunk that left long ago is outside again") {
  PendingChunks pending;
  (void)go(pending, 0, {});
  (void)go(pending, 50, seconds{1});
  (void)go(pending, 51, seconds{100});
  (void)go(pending, 52, seconds{200});
  CHECK(pending.arrive({0, 0, 0}).verdict == Verdict::outside);
}

TEST_CASE("a chunk that left before it came is missed, with its wait") {
  PendingChunks pending;
  (void)go(pending, 0, {});
  CHECK(pending.arrive({-2, 0, 0}).verdict == Verdict::came);
  const auto missed = go(pending, 1, seconds{1});
  CHECK(missed.size() == kSlice - 1);
  CHECK(missed.front().since == kStart);
}

TEST_CASE("a chunk that leaves and returns may come again, or not, and both may cross") {
  PendingChunks pending;
  (void)go(pending, 0, {});
  CHECK(take_all(pending) == kAll);
  (void)go(pending, 1, seconds{1});
  CHECK(take_all(pending) == kSlice);
  (void)go(pending, 0, seconds{2});
  CHECK(pending.waiting() == 0);
  CHECK(pending.arrive({-2, 0, 0}).verdict == Verdict::came);
  CHECK(pending.arrive({-2, 0, 0}).verdict == Verdict::repeated);
  CHECK(pending.arrive({-1, 0, 0}).verdict == Verdict::duplicate);
}

TEST_CASE("a farther chunk before a nearer one is seen in the first View") {
  PendingChunks pending;
  (void)go(pending, 0, {}, 4);
  CHECK(pending.arrive({0, 0, 0}).ring_gap == 0);
  CHECK(pending.arrive({4, 0, 0}).ring_gap == 3);
  (void)go(pending, 1, seconds{1}, 4);
  CHECK(pending.arrive({5, 0, 0}).ring_gap == -1);
}

TEST_CASE("a jump is distinguished from a step") {
  PendingChunks pending;
  (void)go(pending, 0, {});
  CHECK(pending.jumped() == kStart);
  (void)go(pending, 1, seconds{1});
  CHECK(pending.jumped() == kStart);
  (void)go(pending, 100, seconds{2});
  CHECK(pending.jumped() == kStart + seconds{2});
  CHECK(pending.arrive({100, 0, 0}).join);
}

TEST_CASE("giving up reports the chunks that never arrived, and expects nothing more") {
  PendingChunks pending;
  (void)go(pending, 0, {});
  (void)pending.arrive({0, 0, 0});
  CHECK(pending.give_up().size() == kAll - 1);
  CHECK(pending.waiting() == 0);
}

TEST_CASE("pending chunks are the ones that did not come, by any way") {
  rc::prop("for any steps", [](const std::vector<bool>& right) {
    PendingChunks pending;
    std::int64_t x = 0;
    (void)go(pending, x, {});
    (void)take_all(pending);
    int second = 0;
    for (const bool step : right) {
      x += step ? 1 : -1;
      (void)go(pending, x, seconds{++second});
      RC_ASSERT(pending.waiting() <= kSlice);
      (void)take_all(pending);
      RC_ASSERT(pending.waiting() == 0U);
    }
  });
}

TEST_CASE("a View at the world's edge ends there") {
  const std::int64_t edge = chunk_limit(Lod{});
  const Box box = box_around({edge - 1, 0, 0}, 2, 1);
  CHECK(box.high.x == edge - 1);
  CHECK(box.low.x == edge - 3);
}
