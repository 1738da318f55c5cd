#include "edits/entry_queue.h"

#include <catch2/catch.hpp>

namespace talus::server {
namespace {

using namespace std::chrono_literals;
using Queue = EntryQueue<int>;

TEST_CASE("a wake-up reaches the waiting thread, however many takes without waiting precede it") {
  Queue queue{{}};
  queue.wake();
  CHECK(queue.take(10, 10, Queue::TimePoint::min()).empty());
  const auto until = std::chrono::steady_clock::now() + 30s;
  CHECK(queue.take(10, 10, until).empty());
  CHECK(std::chrono::steady_clock::now() < until);
}

}  // namespace
}  // namespace talus::server
