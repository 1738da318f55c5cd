#include "spec/angles.h"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "spec/units.h"

namespace talus::terrain {
namespace {

double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

TEST_CASE("Sines, cosines and tangents of degrees are the C library's but for the last places") {
  int wrong = 0;
  for (int thousandths = -720'000; thousandths <= 720'000; thousandths += 7) {
    const double degrees = thousandths / 1000.0;
    const double sine = std::sin(radians(degrees));
    const double cosine = std::cos(radians(degrees));
    wrong += static_cast<int>(!(std::abs(sine_of_degrees(degrees) - sine) < 3e-15));
    wrong += static_cast<int>(!(std::abs(cosine_of_degrees(degrees) - cosine) < 3e-15));
    const double tangent = std::tan(radians(degrees));
    if (std::abs(tangent) < 100) {
      wrong += static_cast<int>(!(std::abs(tangent_of_degrees(degrees) - tangent) < 1e-10));
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("Angles of worlds are rounded as by the C library, to the thousandth of a degree") {
  int wrong = 0;
  for (int thousandths = 0; thousandths <= 360'000; ++thousandths) {
    const double degrees = thousandths / 1000.0;
    const double angle = radians(degrees);
    wrong += static_cast<int>(rounded(65536 * sine_of_degrees(degrees)) != rounded(65536 * std::sin(angle)));
    wrong +=
        static_cast<int>(rounded(65536 * cosine_of_degrees(degrees)) != rounded(65536 * std::cos(angle)));
    wrong += static_cast<int>(thousandths <= 89'000 && rounded(kSubvoxels * tangent_of_degrees(degrees)) !=
                                                           rounded(kSubvoxels * std::tan(angle)));
  }
  CHECK(wrong == 0);
}

TEST_CASE("Quarter turns are exact") {
  for (const double turns : {0.0, 360.0, -360.0, 1080.0}) {
    CHECK(sine_of_degrees(turns) == 0);
    CHECK(sine_of_degrees(turns + 90) == 1);
    CHECK(sine_of_degrees(turns + 180) == 0);
    CHECK(cosine_of_degrees(turns + 180) == -1);
    CHECK(cosine_of_degrees(turns + 270) == 0);
  }
  CHECK(tangent_of_degrees(0) == 0);
  CHECK(std::abs(tangent_of_degrees(45) - 1) < 1e-15);
}

}  // namespace
}  // namespace talus::terrain
