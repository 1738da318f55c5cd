// The viewer's test/unit/look.test.ts has the same numbers: both read client_sample/look.json.
#include "look.h"

#include <catch2/catch.hpp>

#include "picture.h"
#include "sky.h"

using namespace talus;
using namespace talus::cli;

namespace {

client::Material material(const std::string& name, std::uint32_t colour) {
  client::Material made;
  made.name = name;
  made.colour = colour;
  return made;
}

void check_near(const glm::vec3& light, const glm::vec3& wanted) {
  for (int channel = 0; channel < 3; ++channel)
    CHECK(light[channel] == Approx(wanted[channel]).margin(0.0005));
}

}  // namespace

TEST_CASE("turf is greyer under the sun than on a map, and snow darker; leaves and rock are as they are") {
  const Looks looks;
  check_near(looks.colour_of(material("Grass", 0x6FA845)), {0.1735F, 0.3361F, 0.0869F});
  check_near(looks.colour_of(material("snow", 0xFFFFFF)), {0.80F, 0.83F, 0.87F});
  check_near(looks.colour_of(material("forest needles", 0x6FA845)), to_light(0x6FA845));
  check_near(looks.colour_of(material("dark rock", 0x6FA845)), to_light(0x6FA845));
}

TEST_CASE("the light follows the sun's height") {
  const Sky sky{glm::vec3{0.0F, 0.5F, 0.866F}};
  check_near(sky.sunlight, {4.3F, 3.4026F, 2.3198F});
  check_near(sky.from_above, {0.5058F, 0.6874F, 1.0226F});
  CHECK(sky.exposure == Approx(0.75));
  CHECK(Sky{glm::vec3{0.0F, 0.1F, 0.995F}}.exposure > 1.1F);
}

TEST_CASE("light is shown from black to white, and never beyond") {
  check_near(shown(glm::vec3{0.0F}), glm::vec3{0.0F});
  CHECK(shown(glm::vec3{0.2F}).g < shown(glm::vec3{0.4F}).g);
  CHECK(shown(glm::vec3{100.0F}).g <= 1.0F);
}
