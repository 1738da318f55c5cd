#include "overlay.h"

#include <algorithm>
#include <memory>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

namespace talus::terrain {
namespace {

using Voxels = std::vector<MaterialId>;

MaterialId any_material(int count) {
  return MaterialId{static_cast<std::uint16_t>(*rc::gen::inRange(0, count))};
}

// A row for each column: rough, or flat with a step.
ChunkPlane any_plane() {
  const bool rough = *rc::gen::arbitrary<bool>();
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  ChunkPlane plane;
  std::uint32_t state = seed | 1U;
  for (std::size_t i = 0; i < plane.size(); ++i) {
    if (rough || i % 64 == 0) state = state * 1664525U + 1013904223U;
    plane[i] = static_cast<std::uint8_t>((state >> 16U) % (kChunkSize + 1));
  }
  return plane;
}

Layers any_layers(int most) {
  Layers layers{{any_material(4)}, {}};
  ChunkPlane below{};
  for (int count = *rc::gen::inRange(0, most); count > 0; --count) {
    const ChunkPlane next = any_plane();
    std::transform(below.begin(), below.end(), next.begin(), below.begin(),
                   [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); });
    layers.tops.insert(layers.tops.end(), below.begin(), below.end());
    layers.materials.push_back(any_material(4));
  }
  return layers;
}

Overlay any_overlay() {
  return {any_material(5), any_plane(), any_plane()};
}

Voxels voxels_of(const Chunk& chunk) {
  Voxels voxels(kChunkVolume);
  chunk.copy_to(std::span<MaterialId, kChunkVolume>{voxels});
  return voxels;
}

void write(const Overlay& overlay, Voxels& voxels) {
  for (std::size_t column = 0; column < kChunkArea; ++column) {
    for (std::size_t y = overlay.from[column]; y < overlay.to[column]; ++y) {
      voxels[y * kChunkArea + column] = overlay.material;
    }
  }
}

// As Chunk::at says it, for lists longer than a chunk may have.
Voxels voxels_of(const Layers& layers) {
  Voxels voxels(kChunkVolume);
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    std::size_t layer = 0;
    while (layer < layers.plane_count() && layers.plane(layer)[i % kChunkArea] <= i / kChunkArea) ++layer;
    voxels[i] = layers.materials[layer];
  }
  return voxels;
}

TEST_CASE("An overlay changes the voxels of its intervals and no other") {
  CHECK(rc::check([] {
    Layers layers = any_layers(8);
    const Overlay one = any_overlay();
    Voxels expected = voxels_of(layers);
    write(one, expected);
    apply(one, layers);
    RC_ASSERT(layers.valid());
    RC_ASSERT(voxels_of(layers) == expected);
  }));
}

TEST_CASE("After an overlay no plane bounds nothing") {
  CHECK(rc::check([] {
    Layers layers = any_layers(8);
    Overlay one = any_overlay();
    one.to[0] = static_cast<std::uint8_t>(one.from[0] = 3) + 1;
    apply(one, layers);
    const Layers given = layers;
    const Chunk chunk = Chunk::from_layers(layers);
    RC_ASSERT(chunk.layers()->materials == given.materials);
    RC_ASSERT(chunk.layers()->tops == given.tops);
  }));
}

TEST_CASE("An overlay inside one layer costs two planes") {
  Layers layers{{MaterialId{2}, MaterialId{3}, MaterialId{4}}, {}};
  layers.tops.resize(kChunkArea, 10);
  layers.tops.resize(2 * kChunkArea, 20);
  Overlay cave{kAir, {}, {}};
  for (std::size_t i = 40; i < 200; ++i) {
    cave.from[i] = static_cast<std::uint8_t>(10 + i % 3);
    cave.to[i] = 18;
  }
  apply(cave, layers);
  CHECK(layers.plane_count() == 4);
}

TEST_CASE("An overlay without any interval changes nothing") {
  CHECK(rc::check([] {
    Layers layers = any_layers(6);
    const Layers before = layers;
    apply({any_material(5), {}, {}}, layers);
    RC_ASSERT(layers.materials == before.materials);
    RC_ASSERT(layers.tops == before.tops);
  }));
}

TEST_CASE("A chunk with overlays is the chunk written voxel by voxel, also where layers cannot hold it") {
  CHECK(rc::check([] {
    const Layers layers = any_layers(*rc::gen::element(4, 60, 120));
    std::vector<Overlay> overlays;
    for (int count = *rc::gen::inRange(0, 7); count > 0; --count) overlays.push_back(any_overlay());
    Voxels expected = voxels_of(layers);
    for (const Overlay& each : overlays) write(each, expected);
    RC_ASSERT(voxels_of(chunk_with(layers, overlays)) == expected);
  }));
}

}  // namespace
}  // namespace talus::terrain
