#include <talus/terrain/settle.h>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include "reference.h"

namespace talus::terrain {
namespace {

Field any_field(int most) {
  Field field{*rc::gen::inRange(1, 24), *rc::gen::inRange(1, 24)};
  // Mostly full with holes, or anything: both shapes that slopes give.
  const bool holes = *rc::gen::arbitrary<bool>();
  for (std::int32_t& g : field.values) {
    g = holes ? (*rc::gen::inRange(0, 12) == 0 ? 0 : most) : *rc::gen::inRange(0, most + 1);
  }
  return field;
}

TEST_CASE("Two passes settle exactly as removing material until nothing moves") {
  CHECK(rc::check([] {
    const int c = *rc::gen::inRange(1, 400);
    Field quick = any_field(*rc::gen::inRange(1, 8000));
    Field slow = quick;
    settle(quick, c);
    test::reference::remove_until_stable(slow, c);
    RC_ASSERT(quick.values == slow.values);
  }));
}

TEST_CASE("Long rows settle so, too, by reposes at which vectors of 16 bits give way to wider ones") {
  CHECK(rc::check([] {
    const int c = *rc::gen::inRange(960, 1100);
    Field quick{*rc::gen::inRange(64, 200), *rc::gen::inRange(1, 4)};
    for (std::int32_t& g : quick.values) g = *rc::gen::inRange(0, 80) == 0 ? 0 : 32000;
    Field slow = quick;
    settle(quick, c);
    test::reference::remove_until_stable(slow, c);
    RC_ASSERT(quick.values == slow.values);
  }));
}

TEST_CASE("Settling takes extreme thickness and repose without overflow") {
  CHECK(rc::check([] {
    const int c = *rc::gen::element(1, 2, 14667, 1 << 20);
    Field quick = any_field(1 << 20);
    Field slow = quick;
    if (c < 3) {  // literal removal would take a million sweeps; one column wide it is quick to check
      quick = Field{8, 1};
      quick.at(0, 0) = 1 << 20;
      slow = quick;
    }
    settle(quick, c);
    test::reference::remove_until_stable(slow, c);
    RC_ASSERT(quick.values == slow.values);
  }));
}

TEST_CASE("The starting thickness is equation 3 rounded down") {
  Field slope{5, 1};
  slope.values = {0, 1, 128, 256, 257};
  const Field g = starting_thickness(slope, 1000, 256);
  CHECK(g.values == Field::Values{1000, 996, 500, 0, 0});
  CHECK(starting_thickness(slope, 1 << 20, 14667).values[0] == 1 << 20);
}

}  // namespace
}  // namespace talus::terrain
