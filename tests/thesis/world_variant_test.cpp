#include "world_variant.h"

#include <catch2/catch.hpp>

#include "worlds.h"

using namespace talus;
using namespace talus::tools;

namespace {

WorldText classic_text() {
  return {test::sample_world_text("classic"), "here.toml"};
}

terrain::World variant(const WorldChanges& changes) {
  auto world = world_variant(classic_text(), changes);
  REQUIRE(world);
  return std::move(*world);
}

}  // namespace

TEST_CASE("A world with nothing changed is the world") {
  CHECK(variant({}).canonical_form() == test::sample_world("classic").canonical_form());
}

TEST_CASE("A change back gives the world again, so nothing else is touched") {
  const terrain::World& world = test::sample_world("classic");
  CHECK(variant({.resolution = world.spec().resolution, .exponent = world.spec().surface.exponent})
            .canonical_form() == world.canonical_form());
}

TEST_CASE("Resolution, exponent and roughness are changed where they stand") {
  CHECK(variant({.resolution = 57}).spec().resolution == 57);
  CHECK(variant({.exponent = 2}).spec().surface.exponent == 2);
  const terrain::World rough = variant({.roughness = 1.5});
  for (const auto& material : rough.spec().stratified) CHECK(material.roughness == 1.5);
  CHECK(rough.spec().resolution == test::sample_world("classic").spec().resolution);
}

TEST_CASE("A change that leads out of bounds is reported in one line") {
  const auto world = world_variant(classic_text(), {.resolution = 4000});
  REQUIRE_FALSE(world);
  CHECK_THAT(world.error().message, Catch::StartsWith("here.toml: at resolution 4000: "));
  CHECK(world.error().message.find('\n') == std::string::npos);
}

TEST_CASE("A wrong text is reported by its own line") {
  const auto world = world_variant({"seed = ", "here.toml"}, {.resolution = 100});
  REQUIRE_FALSE(world);
  CHECK_THAT(world.error().message, Catch::StartsWith("here.toml:1: "));
}
