#include "view_waits.h"

#include <catch2/catch.hpp>

#include "worlds.h"

using namespace talus;
using namespace talus::cli;
using std::chrono::milliseconds;
using testing::key_at;

namespace {

client::View around(int chunk_x) {
  return {{chunk_x * kChunkSize, 0, 0}, {}, 1, 0, {}};
}

}  // namespace

TEST_CASE("a chunk's wait is counted from the first View that has it, once") {
  ViewWaits waits;
  const ViewWaits::Time begin{};
  waits.view_set(client::ViewShape{around(0)}, begin);
  waits.view_set(client::ViewShape{around(1)}, begin + milliseconds{10});
  waits.chunk_arrived(key_at(1, 0, 0), begin + milliseconds{30});
  waits.chunk_arrived(key_at(1, 0, 0), begin + milliseconds{99});
  REQUIRE(waits.waits().count() == 1);
  CHECK(waits.waits().max_ms() == 30);
  waits.chunk_arrived(key_at(2, 0, 0), begin + milliseconds{30});
  CHECK(waits.waits().count() == 2);
  CHECK(waits.waits().percentile_ms(0.5) == Approx(20).epsilon(0.001));
}

TEST_CASE("a chunk of no View does not count") {
  ViewWaits waits;
  waits.view_set(client::ViewShape{around(0)}, {});
  waits.chunk_arrived(key_at(9, 0, 0), ViewWaits::Time{} + milliseconds{1});
  CHECK(waits.waits().count() == 0);
}
