// [[placeable]]: materials that are never generated.
#include <catch2/catch.hpp>

#include <string>

#include <talus/terrain/world.h>

#include "worlds.h"
#include "wrong_spec.h"

namespace talus::terrain {
namespace {

std::string with(const std::string& placeables) {
  return test::small_world_text(1) + placeables;
}

}  // namespace

TEST_CASE("placeables are part of a world, and neither of its fingerprint nor of its own materials") {
  const World bare = World::parse(with(""), "w.toml").value();
  const World world = World::parse(with(R"(
[[placeable]]
name = "glass"
colour = "#a0c8d8"

[[placeable]]
name = "lava"
colour = "#ff6000"
phase = "liquid"

[[placeable]]
name = "door"
colour = "#804000"
states = ["shut", "open"]
)"),
                                   "w.toml")
                          .value();
  CHECK(world.fingerprint() == bare.fingerprint());
  CHECK(world.materials().size() == bare.materials().size());
  REQUIRE(world.placeables().size() == 4);
  CHECK(world.placeables()[0].name == "glass");
  CHECK(world.placeables()[0].kind == MaterialKind::stratified);
  CHECK(world.placeables()[0].colour == Colour{0xA0, 0xC8, 0xD8});
  CHECK(world.placeables()[1].kind == MaterialKind::water);
  CHECK(world.placeables()[2].name == "door: shut");
  CHECK(world.placeables()[3].name == "door: open");
}

TEST_CASE("a wrong placeable is refused by its key") {
  const auto refused = [](const std::string& table) {
    return test::error_of(with("\n[[placeable]]\n" + table));
  };
  CHECK(refused("name = \"air\"\ncolour = \"#000000\"").find("placeable[0].name") != std::string::npos);
  CHECK(refused("name = \"glass\"").find("placeable[0].colour: missing") != std::string::npos);
  CHECK(refused("name = \"glass\"\ncolour = \"#000000\"\nphase = \"solud\"").find("placeable[0].phase") !=
        std::string::npos);
  CHECK(refused("name = \"glass\"\ncolour = \"#000000\"\nhard = true").find("hard: unknown key") !=
        std::string::npos);
  CHECK(
      refused("name = \"door\"\ncolour = \"#000000\"\nstates = [\"a\", \"a\"]").find("placeable[0].states") !=
      std::string::npos);
  std::string many;
  for (int i = 0; i < 1025; ++i) {
    many += "\n[[placeable]]\nname = \"p" + std::to_string(i) + "\"\ncolour = \"#000000\"\n";
  }
  CHECK(test::error_of(with(many)).find("at most 1024") != std::string::npos);
}

}  // namespace talus::terrain
