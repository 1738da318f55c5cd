#include <talus/tools/ordered_work.h>

#include <atomic>
#include <stdexcept>
#include <vector>

#include <catch2/catch.hpp>

using namespace talus::tools;

TEST_CASE("Results are consumed in order, each once, on any number of threads") {
  for (const int threads : {1, 2, 7}) {
    std::vector<std::size_t> seen;
    CHECK(work_in_order(
        200, threads, [](std::size_t i) { return i * i; },
        [&](std::size_t, std::size_t square) {
          seen.push_back(square);
          return true;
        }));
    REQUIRE(seen.size() == 200);
    for (std::size_t i = 0; i < seen.size(); ++i) CHECK(seen[i] == i * i);
  }
}

TEST_CASE("No more than the window is produced ahead of the consumer") {
  std::atomic<std::size_t> started{0};
  std::size_t furthest = 0;
  work_in_order(
      300, 3, [&](std::size_t) { return ++started; },
      [&](std::size_t index, std::size_t) {
        furthest = std::max(furthest, started.load() - index);
        return true;
      });
  CHECK(furthest <= 3 * 4 + 1);
}

TEST_CASE("A consumer that has enough ends the work") {
  std::size_t consumed = 0;
  CHECK_FALSE(work_in_order(
      1000, 4, [](std::size_t i) { return i; }, [&](std::size_t, std::size_t) { return ++consumed < 10; }));
  CHECK(consumed == 10);
}

TEST_CASE("An exception of a producer reaches the caller") {
  const auto fail_late = [](std::size_t i) {
    if (i == 50) throw std::runtime_error{"no more"};
    return i;
  };
  CHECK_THROWS_WITH(work_in_order(100, 4, fail_late, [](std::size_t, std::size_t) { return true; }),
                    "no more");
}

TEST_CASE("No work is not an error") {
  CHECK(work_in_order(
      0, 4, [](std::size_t i) { return i; }, [](std::size_t, std::size_t) { return true; }));
}
