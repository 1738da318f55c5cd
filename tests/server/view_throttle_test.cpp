#include "net/view_throttle.h"

#include <catch2/catch.hpp>

using talus::server::Clock;
using talus::server::ViewThrottle;
using namespace std::chrono_literals;

namespace {
constexpr Clock::time_point kBegan = Clock::time_point{} + 1h;
}

TEST_CASE("the first View is applied at once") {
  CHECK(ViewThrottle{}.due() < kBegan);
}

TEST_CASE("a cheap View is followed by the next 20 ms later at the earliest") {
  ViewThrottle throttle;
  throttle.applied(kBegan, 1us);
  CHECK(throttle.due() == kBegan + 20ms);
}

TEST_CASE("an expensive View delays the next one until it was a tenth of the time") {
  ViewThrottle throttle;
  throttle.applied(kBegan, 35ms);
  CHECK(throttle.due() == kBegan + 350ms);
}
