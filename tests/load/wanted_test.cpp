#include "wanted.h"

#include <rapidcheck/catch.h>
#include <catch2/catch.hpp>

using namespace talus;
using namespace talus::load;
using std::chrono::milliseconds;
using std::chrono::seconds;
using Verdict = Wanted::Verdict;

namespace {

const Time kStart = Time{} + seconds{1000};

std::vector<Wanted::Missed> go(Wanted& wanted, std::int64_t x, Clock::duration at, int radius = 2) {
  const glm::i64vec3 centre{x, 0, 0};
  return wanted.move_to(box_around(centre, radius, 1), centre, kStart + at);
}

std::size_t take_all(Wanted& wanted) {
  std::size_t came = 0;
  const Box box = wanted.box();
  for (std::int64_t x = box.low.x; x <= box.high.x; ++x) {
    for (std::int64_t y = box.low.y; y <= box.high.y; ++y) {
      for (std::int64_t z = box.low.z; z <= box.high.z; ++z) {
        const ChunkCoord chunk{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y),
                               static_cast<std::int32_t>(z)};
        if (wanted.arrive(chunk).verdict == Verdict::came) ++came;
      }
    }
  }
  return came;
}

constexpr std::size_t kAll = 5 * 3 * 5;
constexpr std::size_t kSlice = 3 * 5;

}  // namespace

TEST_CASE("a chunk's wait begins with the View that first wanted it") {
  Wanted wanted;
  (void)go(wanted, 0, milliseconds{0});
  (void)go(wanted, 1, milliseconds{500});
  const auto old = wanted.arrive({0, 0, 0});
  CHECK(old.since == kStart);
  CHECK(old.steps_late == 1);
  CHECK(old.join);
  const auto fresh = wanted.arrive({3, 0, 0});
  CHECK(fresh.since == kStart + milliseconds{500});
  CHECK(fresh.steps_late == 0);
  CHECK_FALSE(fresh.join);
}

TEST_CASE("a chunk comes once") {
  Wanted wanted;
  (void)go(wanted, 0, {});
  CHECK(wanted.arrive({1, 1, 1}).verdict == Verdict::came);
  CHECK(wanted.arrive({1, 1, 1}).verdict == Verdict::duplicate);
}

TEST_CASE("what stays in the View is not wanted again") {
  Wanted wanted;
  (void)go(wanted, 0, {});
  CHECK(take_all(wanted) == kAll);
  (void)go(wanted, 1, seconds{1});
  CHECK(wanted.waiting() == kSlice);
  CHECK(wanted.arrive({0, 0, 0}).verdict == Verdict::duplicate);
}

TEST_CASE("what was never asked for is outside; what just left is only late") {
  Wanted wanted;
  (void)go(wanted, 0, {});
  (void)go(wanted, 1, seconds{1});
  CHECK(wanted.arrive({-2, 0, 0}).verdict == Verdict::stale);
  CHECK(wanted.arrive({-3, 0, 0}).verdict == Verdict::outside);
  CHECK(wanted.arrive({0, 2, 0}).verdict == Verdict::outside);
}

TEST_CASE("what left long ago is outside again") {
  Wanted wanted;
  (void)go(wanted, 0, {});
  (void)go(wanted, 50, seconds{1});
  (void)go(wanted, 51, seconds{100});
  (void)go(wanted, 52, seconds{200});
  CHECK(wanted.arrive({0, 0, 0}).verdict == Verdict::outside);
}

TEST_CASE("what left before it came is missed, with its wait") {
  Wanted wanted;
  (void)go(wanted, 0, {});
  CHECK(wanted.arrive({-2, 0, 0}).verdict == Verdict::came);
  const auto missed = go(wanted, 1, seconds{1});
  CHECK(missed.size() == kSlice - 1);
  CHECK(missed.front().since == kStart);
}

TEST_CASE("what leaves and comes back may come again, or not, and both may cross") {
  Wanted wanted;
  (void)go(wanted, 0, {});
  CHECK(take_all(wanted) == kAll);
  (void)go(wanted, 1, seconds{1});
  CHECK(take_all(wanted) == kSlice);
  (void)go(wanted, 0, seconds{2});
  CHECK(wanted.waiting() == 0);
  CHECK(wanted.arrive({-2, 0, 0}).verdict == Verdict::came);
  CHECK(wanted.arrive({-2, 0, 0}).verdict == Verdict::repeated);
  CHECK(wanted.arrive({-1, 0, 0}).verdict == Verdict::duplicate);
}

TEST_CASE("a farther chunk before a nearer one is seen in the first View") {
  Wanted wanted;
  (void)go(wanted, 0, {}, 4);
  CHECK(wanted.arrive({0, 0, 0}).ring_gap == 0);
  CHECK(wanted.arrive({4, 0, 0}).ring_gap == 3);
  (void)go(wanted, 1, seconds{1}, 4);
  CHECK(wanted.arrive({5, 0, 0}).ring_gap == -1);
}

TEST_CASE("a jump is told from a step") {
  Wanted wanted;
  (void)go(wanted, 0, {});
  CHECK(wanted.jumped() == kStart);
  (void)go(wanted, 1, seconds{1});
  CHECK(wanted.jumped() == kStart);
  (void)go(wanted, 100, seconds{2});
  CHECK(wanted.jumped() == kStart + seconds{2});
  CHECK(wanted.arrive({100, 0, 0}).join);
}

TEST_CASE("giving up tells what never came, and wants nothing more") {
  Wanted wanted;
  (void)go(wanted, 0, {});
  (void)wanted.arrive({0, 0, 0});
  CHECK(wanted.give_up().size() == kAll - 1);
  CHECK(wanted.waiting() == 0);
}

TEST_CASE("what waits is what did not come, whatever the way") {
  rc::prop("for any steps", [](const std::vector<bool>& right) {
    Wanted wanted;
    std::int64_t x = 0;
    (void)go(wanted, x, {});
    (void)take_all(wanted);
    int second = 0;
    for (const bool step : right) {
      x += step ? 1 : -1;
      (void)go(wanted, x, seconds{++second});
      RC_ASSERT(wanted.waiting() <= kSlice);
      (void)take_all(wanted);
      RC_ASSERT(wanted.waiting() == 0U);
    }
  });
}

TEST_CASE("a View at the world's edge ends there") {
  const std::int64_t edge = chunk_limit(Lod{});
  const Box box = box_around({edge - 1, 0, 0}, 2, 1);
  CHECK(box.high.x == edge - 1);
  CHECK(box.low.x == edge - 3);
}
