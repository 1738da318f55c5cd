#include "player/session/chunk_waits.h"

#include <catch2/catch.hpp>

using namespace talus;
using namespace talus::server;

namespace {

const ChunkKey kKey{{1, 2, 3}, Lod{}};
const ChunkKey kOther{{4, 5, 6}, Lod{}};
const ChunkKey kStays{{7, 8, 9}, Lod{}};
constexpr Clock::time_point kNow{std::chrono::seconds{1}};

}  // namespace

TEST_CASE("the last request that leaves a chunk cancels it") {
  ChunkWaits waits;
  waits.add(kKey, kNow).requests = {1, 2};
  CHECK_FALSE(waits.leave(kKey, 1));
  CHECK(waits.leave(kKey, 2));
  CHECK_FALSE(waits.contains(kKey));
}

TEST_CASE("the View that leaves chunks does not cancel chunks that a request waits for") {
  ChunkWaits waits;
  auto& waiters = waits.add(kKey, kNow);
  waiters.view = true;
  waiters.requests = {1};
  waits.add(kOther, kNow).view = true;
  waits.add(kStays, kNow).view = true;
  const auto left = waits.leave_view_where([](ChunkKey key) { return key != kStays; });
  CHECK(left == std::vector{kOther});
  CHECK(waits.size() == 2);
  CHECK(waits.leave(kKey, 1));
}

TEST_CASE("a chunk that the View has otherwise is expected all the same") {
  ChunkWaits waits;
  waits.add(kKey, kNow).view = true;
  CHECK(waits.end_view(kKey));
  CHECK(waits.leave_view_where([](ChunkKey) { return true; }).empty());
  CHECK_FALSE(waits.end_view(kKey));  // no more
  CHECK_FALSE(waits.take(kKey)->view);
  waits.add(kOther, kNow).requests = {1};
  CHECK_FALSE(waits.end_view(kOther));  // for which a request alone waits
}

TEST_CASE("a request that leaves a chunk does not cancel it for the View") {
  ChunkWaits waits;
  auto& waiters = waits.add(kKey, kNow);
  waiters.view = true;
  waiters.requests = {1};
  CHECK_FALSE(waits.leave(kKey, 1));
  CHECK(waits.leave_view_where([](ChunkKey) { return true; }) == std::vector{kKey});
}

TEST_CASE("leaving a chunk without waiting clients cancels nothing") {
  ChunkWaits waits;
  CHECK_FALSE(waits.leave(kKey, 1));
  CHECK_FALSE(waits.end_view(kKey));
}

TEST_CASE("a chunk that came is waited for no more") {
  ChunkWaits waits;
  waits.add(kKey, kNow).requests = {1, 2};
  const auto waiters = waits.take(kKey);
  REQUIRE(waiters);
  CHECK(waiters->since == kNow);
  CHECK(waiters->requests == std::vector<std::uint32_t>{1, 2});
  CHECK_FALSE(waits.take(kKey));
  CHECK(waits.size() == 0);
}
