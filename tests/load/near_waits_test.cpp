#include "near_waits.h"

#include <catch2/catch.hpp>

using namespace talus;
using namespace talus::load;
using std::chrono::milliseconds;

namespace {

const Time kStart = Time{} + std::chrono::seconds{1000};

Time at(int ms) {
  return kStart + milliseconds{ms};
}

/// A player whose View is a row of chunks, 11 long: its nearest rings are three of them.
struct Flyer {
  PendingChunks pending;
  NearWaits waits;
  std::vector<int> near;  // milliseconds, in the order in which they were done

  void step(int ms, std::int64_t x) {
    const glm::i64vec3 centre{x, 0, 0};
    Box box{{x - 5, 0, 0}, {x + 5, 0, 0}};
    (void)pending.move_to(box, centre, at(ms), at(ms));
    waits.step(at(ms), pending);
    note();
  }
  void come(int ms, int x) {
    REQUIRE(pending.arrive({x, 0, 0}).verdict == PendingChunks::Verdict::came);
    waits.came(at(ms), pending);
    note();
  }
  void note() {
    for (const NearWaits::Wait& wait : waits.take_done()) {
      near.push_back(static_cast<int>(std::chrono::duration_cast<milliseconds>(wait.time).count()));
    }
  }
  [[nodiscard]] int longest() const {
    return static_cast<int>(std::chrono::duration_cast<milliseconds>(waits.longest_without()).count());
  }
};

}  // namespace

TEST_CASE("a View's nearest rings are there when the last of their chunks has come") {
  Flyer flyer;
  flyer.step(0, 0);
  CHECK(flyer.pending.near_waiting() == 3);
  flyer.come(10, 5);
  flyer.come(20, -1);
  flyer.come(30, 0);
  CHECK(flyer.near.empty());
  flyer.come(40, 1);
  CHECK(flyer.near == std::vector{40});
}

TEST_CASE("a step into what is held waits for nothing") {
  Flyer flyer;
  flyer.step(0, 0);
  for (int x = -1; x <= 2; ++x) flyer.come(10, x);
  flyer.step(500, 1);
  CHECK(flyer.near == std::vector{10, 0});
}

TEST_CASE("each View without its rings waits until the newest View's rings arrive") {
  Flyer flyer;
  flyer.step(0, 0);
  flyer.step(1'000, 1);
  flyer.come(1'010, 0);
  flyer.come(1'020, 1);
  CHECK(flyer.near.empty());
  flyer.come(1'500, 2);
  CHECK(flyer.near == std::vector{1'500, 500});
}

TEST_CASE("a ring that never arrives counts with the time waited for it") {
  Flyer flyer;
  flyer.step(0, 0);
  flyer.waits.stop(at(700));
  flyer.note();
  CHECK(flyer.near == std::vector{700});
  CHECK(flyer.longest() == 700);
}

TEST_CASE("the longest time without a chunk is one in which a player waited for some") {
  Flyer flyer;
  flyer.step(0, 0);
  for (int x = -5; x <= 5; ++x) flyer.come(10 * (x + 6), x);
  CHECK(flyer.longest() == 10);
  flyer.step(5'000, 1);  // nothing was waited for until now
  flyer.come(5'300, 6);
  CHECK(flyer.longest() == 300);
}

TEST_CASE("time before the measured time does not count") {
  Flyer flyer;
  flyer.waits.measure_from(at(900));
  flyer.step(0, 0);
  flyer.come(1'000, 0);
  CHECK(flyer.longest() == 100);
}
