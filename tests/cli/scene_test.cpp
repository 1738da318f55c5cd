#include "scene.h"

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "worlds.h"

using namespace talus;
using namespace talus::cli;
using namespace talus::cli::testing;

namespace {

constexpr glm::dvec3 kDown{0, -1, 0};

/// From a voxel's middle, in coordinates of the scene.
glm::dvec3 above(const Scene& scene, double x, double y, double z) {
  return glm::dvec3{x, y, z} - glm::dvec3{to_vec(scene.origin())};
}

}  // namespace

TEST_CASE("a ray meets the top of the ground, face up") {
  client::ChunkStore store{1 << 20};
  store.put(received(key_at(0, 0, 0), flat(kStone, 10, kAir)));
  const Scene scene{store, materials(), {5, 20, 5}};
  const auto hit = scene.cast(above(scene, 5.5, 20, 5.5), kDown, 100, Scene::Stop::at_anything);
  REQUIRE(hit);
  CHECK(hit->distance == Approx(10).margin(1e-3));
  CHECK(hit->normal == glm::ivec3{0, 1, 0});
  CHECK(hit->material == to_integer(kStone));
  CHECK(hit->size == 1);
  CHECK(hit->voxel.y + scene.origin().y == 9);
}

TEST_CASE("a ray meets nothing without known chunks, and beyond its reach") {
  client::ChunkStore store{1 << 20};
  store.put(received(key_at(0, 0, 0), flat(kStone, 10, kAir)));
  const Scene scene{store, materials(), {5, 20, 5}};
  CHECK_FALSE(scene.cast(above(scene, 40.5, 20, 5.5), kDown, 100, Scene::Stop::at_anything));
  CHECK_FALSE(scene.cast(above(scene, 5.5, 20, 5.5), kDown, 9, Scene::Stop::at_anything));
}

TEST_CASE("a ray that stops at solid ground goes through water") {
  client::ChunkStore store{1 << 20};
  store.put(received(key_at(0, 0, 0), layered(kStone, 4, kWater, 12)));
  const Scene scene{store, materials(), {5, 20, 5}};
  const glm::dvec3 from = above(scene, 5.5, 20, 5.5);
  CHECK(scene.cast(from, kDown, 100, Scene::Stop::at_anything)->distance == Approx(8).margin(1e-3));
  CHECK(scene.cast(from, kDown, 100, Scene::Stop::at_solid)->distance == Approx(16).margin(1e-3));
  CHECK(scene.liquid(static_cast<std::uint8_t>(to_integer(kWater))));
  CHECK_FALSE(scene.liquid(static_cast<std::uint8_t>(to_integer(kStone))));
}

TEST_CASE("a coarse chunk shows where no finer one is held, by larger voxels") {
  client::ChunkStore store{1 << 20};
  store.put(received(key_at(0, 0, 0, 1), flat(kStone, 10, kAir)));
  store.put(received(key_at(0, 0, 0), flat(kGrass, 6, kAir)));
  const Scene scene{store, materials(), {5, 40, 5}};
  const auto fine = scene.cast(above(scene, 5.5, 31, 5.5), kDown, 100, Scene::Stop::at_solid);
  REQUIRE(fine);
  CHECK(fine->material == to_integer(kGrass));
  const auto coarse = scene.cast(above(scene, 40.5, 60, 5.5), kDown, 100, Scene::Stop::at_solid);
  REQUIRE(coarse);
  CHECK(coarse->material == to_integer(kStone));
  CHECK(coarse->size == 2);
  CHECK(coarse->distance == Approx(40).margin(1e-3));
}

TEST_CASE("a slanting ray meets the side of a step") {
  client::ChunkStore store{1 << 20};
  store.put(received(key_at(0, 0, 0), flat(kStone, 4, kAir)));
  store.put(received(key_at(1, 0, 0), flat(kStone, 20, kAir)));
  const Scene scene{store, materials(), {5, 20, 5}};
  const auto hit = scene.cast(above(scene, 5.5, 15, 5.5), {1, 0, 0}, 100, Scene::Stop::at_solid);
  REQUIRE(hit);
  CHECK(hit->normal == glm::ivec3{-1, 0, 0});
  CHECK(hit->distance == Approx(26.5).margin(1e-3));
}

TEST_CASE("a point of the ground is solid, and one of the air or of nowhere is not") {
  client::ChunkStore store{1 << 20};
  store.put(received(key_at(-1, -1, -1), flat(kStone, 10, kAir)));
  const Scene scene{store, materials(), {-5, -20, -5}};
  const auto at = [&](int x, int y, int z) {
    return glm::ivec3{glm::i64vec3{x, y, z} - to_vec(scene.origin())};
  };
  CHECK(scene.solid_at(at(-1, -32, -1)));
  CHECK(scene.solid_at(at(-1, -23, -1)));
  CHECK_FALSE(scene.solid_at(at(-1, -22, -1)));
  CHECK_FALSE(scene.solid_at(at(0, -32, -1)));
}
