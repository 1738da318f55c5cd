#include "sky.h"

#include <rapidcheck.h>
#include <catch2/catch.hpp>

using namespace talus::cli;

namespace {

glm::vec3 random_direction() {
  const auto part = [] { return static_cast<float>(*rc::gen::inRange(-1000, 1001)) / 1000.0F; };
  const glm::vec3 direction{part(), part(), part()};
  RC_PRE(glm::length(direction) > 0.01F);
  return glm::normalize(direction);
}

float brightness(const glm::vec3& light) {
  return light.r + light.g + light.b;
}

}  // namespace

TEST_CASE("clouds cover from zero to all of the sky, and nothing below the horizon") {
  CHECK(rc::check([] {
    const glm::vec3 direction = random_direction();
    const float cover = cloud_cover(direction);
    RC_ASSERT(cover >= 0.0F);
    RC_ASSERT(cover <= 1.0F);
    if (direction.y <= 0) RC_ASSERT(cover == 0.0F);
  }));
}

TEST_CASE("light is finite and not negative in every direction") {
  CHECK(rc::check([] {
    Sky sky;
    sky.to_sun = glm::normalize(glm::vec3{0.3F, 0.5F, 0.8F});
    const glm::vec3 direction = random_direction();
    for (const glm::vec3& light : {sky.seen(direction), sky.haze(direction), sky.ambient(direction)}) {
      for (int channel = 0; channel < 3; ++channel) {
        RC_ASSERT(std::isfinite(light[channel]));
        RC_ASSERT(light[channel] >= 0.0F);
      }
    }
  }));
}

TEST_CASE("the sky is brightest at the sun") {
  Sky sky;
  sky.to_sun = glm::normalize(glm::vec3{0.0F, 0.5F, 0.9F});
  CHECK(brightness(sky.seen(sky.to_sun)) >
        brightness(sky.seen(glm::normalize(glm::vec3{0.0F, 0.5F, -0.9F}))));
}

TEST_CASE("a face that looks up has more of the sky's light than one that looks down") {
  const Sky sky;
  CHECK(brightness(sky.ambient({0, 1, 0})) > brightness(sky.ambient({0, -1, 0})));
}
