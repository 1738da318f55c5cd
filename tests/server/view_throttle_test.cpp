#include "net/view_pace.h"

#include <catch2/catch.hpp>

using talus::server::ViewPace;
using namespace std::chrono_literals;

TEST_CASE("the first View is taken up at once") {
  CHECK(ViewPace{}.due() < ViewPace::Clock::now());
}

TEST_CASE("a cheap View is followed by the next 20 ms later at the earliest") {
  ViewPace pace;
  const auto began = ViewPace::Clock::now();
  pace.taken_up(began, 1us);
  CHECK(pace.due() == began + 20ms);
}

TEST_CASE("a dear View keeps the next one off until it was a tenth of the time") {
  ViewPace pace;
  const auto began = ViewPace::Clock::now();
  pace.taken_up(began, 35ms);
  CHECK(pace.due() == began + 350ms);
}
