#include "flight.h"

#include <algorithm>

#include <rapidcheck.h>
#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

using namespace talus::cli;

TEST_CASE("a course begins at its start, along its heading") {
  const Course course{{100, -50}, 0, 1000};
  CHECK(course.at(0) == glm::dvec2{100, -50});
  CHECK(course.direction(0).x == Approx(1).margin(1e-3));
  CHECK(course.at(1000).x == Approx(1100));
  CHECK(course.at(1000).y == Approx(-50).margin(1e-6));
}

TEST_CASE("headings of the compass turn clockwise from north") {
  const auto way = [](double degrees) { return Course{{0, 0}, radians_of(degrees), 100}.at(100); };
  CHECK(way(0).y == Approx(-100));
  CHECK(way(90).x == Approx(100));
  CHECK(way(180).y == Approx(100));
  CHECK(way(-90).x == Approx(-100));
}

TEST_CASE("a course's direction is the way to its next point, of length 1") {
  const Course course{{0, 0}, 1, 600};
  for (double distance = 1; distance < 600; distance += 37) {
    const glm::dvec2 step = course.at(distance + 0.01) - course.at(distance - 0.01);
    CHECK(glm::length(course.direction(distance)) == Approx(1));
    CHECK(glm::dot(glm::normalize(step), course.direction(distance)) == Approx(1).margin(1e-4));
  }
}

TEST_CASE("the heading with mountains at its end is chosen, and not one that climbs on the way") {
  std::vector<std::int32_t> heights(static_cast<std::size_t>(kHeadings * kSamplesPerHeading), 256 * 10);
  const auto raise = [&](int heading, int from, int to) {
    for (int sample = from; sample < to; ++sample) {
      heights[static_cast<std::size_t>(heading * kSamplesPerHeading + sample)] = 256 * 200;
    }
  };
  raise(5, kSamplesPerHeading * 2 / 3, kSamplesPerHeading);
  raise(9, 0, kSamplesPerHeading);
  CHECK(choose_heading(heights) == Approx(6.283185307179586 * 5 / kHeadings));
}

TEST_CASE("there is a column for each height that is asked for") {
  CHECK(candidate_columns({0, 0}, 500).size() == std::size_t{kHeadings} * kSamplesPerHeading);
  const Course course{{0, 0}, 0, 500};
  CHECK(static_cast<double>(course_columns(course).size()) * kCourseSpacing > course.length());
}

TEST_CASE("a flight keeps its clearance above every height along the course") {
  CHECK(rc::check([] {
    const auto heights =
        *rc::gen::nonEmpty(rc::gen::container<std::vector<std::int32_t>>(rc::gen::inRange(-20'000, 80'000)));
    const double clearance = *rc::gen::inRange(1, 100);
    const Altitude altitude{heights, clearance};
    for (std::size_t i = 0; i < heights.size(); ++i) {
      RC_ASSERT(altitude.at(static_cast<double>(i) * kCourseSpacing) >=
                heights[i] / 256.0 + clearance - 1e-6);
    }
    const double lowest = *std::min_element(heights.begin(), heights.end()) / 256.0 + clearance;
    RC_ASSERT(altitude.at(-100) >= lowest - 1e-6);
    RC_ASSERT(altitude.at(1e9) >= lowest - 1e-6);
  }));
}
