#include <algorithm>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <talus/voxel/chunk.h>
#include <talus/voxel/content_hash.h>

#include "sample_chunks.h"

namespace talus {
namespace {

using namespace testing;

constexpr MaterialId kRock{5};
constexpr MaterialId kSoil{6};

std::vector<std::uint8_t> flat_planes(std::initializer_list<int> rows) {
  std::vector<std::uint8_t> tops;
  for (const int row : rows) tops.insert(tops.end(), kChunkArea, static_cast<std::uint8_t>(row));
  return tops;
}

/// The definition of a layer's voxels, written as plainly as can be.
MaterialId defined_at(const Layers& layers, int x, int y, int z) {
  for (std::size_t p = 0; p < layers.plane_count(); ++p) {
    if (y < layers.plane(p)[column_index(x, z)]) return layers.materials[p];
  }
  return layers.materials.back();
}

}  // namespace

TEST_CASE("layers become the voxels that their definition gives") {
  CHECK(rc::check([](std::uint64_t seed) {
    const auto planes = *rc::gen::inRange<std::size_t>(0, Layers::kMaxMaterials);
    const Layers layers = random_layers(seed, planes, *rc::gen::inRange(0, 64));
    RC_ASSERT(layers.valid());
    const auto voxels = voxels_of(Chunk::from_layers(layers));
    for (std::uint8_t y = 0; y < kChunkSize; ++y) {
      for (std::uint8_t z = 0; z < kChunkSize; ++z) {
        for (std::uint8_t x = 0; x < kChunkSize; ++x) {
          RC_ASSERT((*voxels)[voxel_index({x, y, z})] == defined_at(layers, x, y, z));
        }
      }
    }
  }));
}

TEST_CASE("copy_to, at and runs agree") {
  CHECK(rc::check([] {
    const Chunk chunk = any_chunk();
    const auto voxels = voxels_of(chunk);
    for (std::uint8_t z = 0; z < kChunkSize; ++z) {
      for (std::uint8_t x = 0; x < kChunkSize; ++x) {
        std::uint8_t reached = 0;
        for (const Run& run : chunk.runs(x, z)) {
          RC_ASSERT(run.from == reached);
          RC_ASSERT(run.from < run.to);
          for (std::uint8_t y = run.from; y < run.to; ++y) {
            RC_ASSERT(chunk.at({x, y, z}) == run.material);
            RC_ASSERT((*voxels)[voxel_index({x, y, z})] == run.material);
          }
          reached = run.to;
        }
        RC_ASSERT(reached == kChunkSize);
      }
    }
  }));
}

TEST_CASE("runs join neighbours of one material") {
  CHECK(rc::check([] {
    const auto runs = any_chunk().runs(*rc::gen::inRange(0, 32), *rc::gen::inRange(0, 32));
    const auto same = [](const Run& a, const Run& b) { return a.material == b.material; };
    RC_ASSERT(std::adjacent_find(runs.begin(), runs.end(), same) == runs.end());
  }));
}

TEST_CASE("both forms of the same voxels are equal") {
  CHECK(rc::check([] {
    const Chunk chunk = any_chunk();
    RC_ASSERT(Chunk::from_dense(*voxels_of(chunk)) == chunk);
  }));
}

TEST_CASE("one differing voxel makes chunks differ") {
  CHECK(rc::check([] {
    const Chunk chunk = any_chunk();
    const auto voxels = voxels_of(chunk);
    MaterialId& voxel = (*voxels)[*rc::gen::inRange<std::size_t>(0, kChunkVolume)];
    voxel = MaterialId{static_cast<std::uint16_t>(to_integer(voxel) ^ 1U)};
    RC_ASSERT_FALSE(Chunk::from_dense(*voxels) == chunk);
  }));
}

TEST_CASE("no kept plane bounds nothing, and neighbours differ") {
  CHECK(rc::check([](std::uint64_t seed) {
    const auto planes = *rc::gen::inRange<std::size_t>(0, 12);
    const Chunk chunk = Chunk::from_layers(random_layers(seed, planes, 200));
    const Layers& kept = *chunk.layers();
    RC_ASSERT(kept.valid());
    std::vector<std::uint8_t> below(kChunkArea, 0);
    for (std::size_t p = 0; p < kept.plane_count(); ++p) {
      RC_ASSERT(kept.materials[p] != kept.materials[p + 1]);
      const std::vector<std::uint8_t> plane(kept.plane(p).begin(), kept.plane(p).end());
      RC_ASSERT(plane != below);
      below = plane;
    }
    RC_ASSERT(below != std::vector<std::uint8_t>(kChunkArea, kChunkSize));
  }));
}

TEST_CASE("needless planes are removed wherever they lie") {
  const Chunk plain = Chunk::from_layers({{kRock, kAir}, flat_planes({7})});
  const auto same_layers = [&plain](const Layers& needless) {
    const Chunk chunk = Chunk::from_layers(needless);
    return chunk.layers()->materials == plain.layers()->materials &&
           chunk.layers()->tops == plain.layers()->tops;
  };
  CHECK(same_layers({{kSoil, kRock, kAir}, flat_planes({0, 7})}));
  CHECK(same_layers({{kRock, kSoil, kAir}, flat_planes({7, 7})}));
  CHECK(same_layers({{kRock, kAir, kSoil}, flat_planes({7, 32})}));
  CHECK(same_layers({{kRock, kRock, kAir}, flat_planes({3, 7})}));
  CHECK(same_layers({{kRock, kSoil, kRock, kAir}, flat_planes({3, 3, 7})}));
}

TEST_CASE("layers of one material are uniform") {
  CHECK(Chunk::from_layers({{kRock}, {}}).is_uniform());
  CHECK(Chunk::from_layers({{kRock, kAir}, flat_planes({32})}).is_uniform());
  CHECK(Chunk::from_layers({{kRock, kAir}, flat_planes({0})}) == Chunk::uniform(kAir));
  CHECK(Chunk::from_layers({{kRock, kSoil, kRock}, flat_planes({9, 9})}) == Chunk::uniform(kRock));
}

TEST_CASE("dense voxels of one material are uniform") {
  const Chunk chunk = Chunk::from_dense(*voxels_of(Chunk::uniform(kSoil)));
  CHECK(chunk.is_uniform());
  CHECK(chunk.layers() != nullptr);
}

TEST_CASE("layers may have holes") {
  const Chunk cave = Chunk::from_layers({{kRock, kAir, kRock, kAir}, flat_planes({4, 6, 20})});
  CHECK(cave.runs(0, 31) == std::vector<Run>{{kRock, 0, 4}, {kAir, 4, 6}, {kRock, 6, 20}, {kAir, 20, 32}});
}

TEST_CASE("layers are valid only in size, range and order") {
  CHECK(Layers{{kRock}, {}}.valid());
  CHECK(Layers{{kRock, kSoil, kAir}, flat_planes({0, 32})}.valid());
  CHECK_FALSE(Layers{}.valid());
  CHECK_FALSE(Layers{{kRock}, flat_planes({1})}.valid());
  CHECK_FALSE(Layers{{kRock, kAir}, {}}.valid());
  CHECK_FALSE(Layers{{kRock, kAir}, flat_planes({33})}.valid());
  CHECK_FALSE(Layers{{kRock, kSoil, kAir}, flat_planes({5, 4})}.valid());
  CHECK_FALSE(Layers{std::vector<MaterialId>(65, kRock), std::vector<std::uint8_t>(64 * kChunkArea)}.valid());
}

TEST_CASE("overrides change the voxels that they name, in any order, the last one counting") {
  CHECK(rc::check([](std::uint64_t seed) {
    const Chunk base = Chunk::from_layers(hill(seed));
    std::vector<Override> overrides;
    auto expected = voxels_of(base);
    for (int count = *rc::gen::inRange(0, 200); count > 0; --count) {
      const Override each{*rc::gen::inRange<std::uint16_t>(0, kChunkVolume),
                          MaterialId{*rc::gen::inRange<std::uint16_t>(0, 9)}};
      overrides.push_back(each);
      (*expected)[each.index] = each.material;
    }
    const Chunk chunk = base.with_overrides(overrides);
    RC_ASSERT(*voxels_of(chunk) == *expected);
    RC_ASSERT(chunk == Chunk::from_dense(*expected));
    RC_ASSERT(content_hash(chunk) == content_hash(Chunk::from_dense(*expected)));
    for (std::uint16_t index = 0; index < kChunkVolume; index = static_cast<std::uint16_t>(index + 37)) {
      const LocalPos pos{static_cast<std::uint8_t>(index % 32), static_cast<std::uint8_t>(index / 1024),
                         static_cast<std::uint8_t>(index / 32 % 32)};
      RC_ASSERT(chunk.at(pos) == (*expected)[index]);
    }
    RC_ASSERT(chunk.runs(3, 5) == Chunk::from_dense(*expected).runs(3, 5));
    const std::size_t half = overrides.size() / 2;
    const Chunk twice = base.with_overrides(std::span{overrides}.first(half))
                            .with_overrides(std::span{overrides}.subspan(half));
    RC_ASSERT(twice == chunk);
  }));
}

TEST_CASE("overrides leave layers as they are under them") {
  const Chunk base = Chunk::from_layers({{kRock, kAir}, flat_planes({9})});
  const Chunk chunk = base.with_overrides(std::vector<Override>{{4000, kSoil}, {7, kSoil}, {8, kRock}});
  CHECK(chunk.layers() == nullptr);
  CHECK(chunk.dense() == nullptr);
  REQUIRE(chunk.base() != nullptr);
  CHECK(chunk.base()->tops == base.layers()->tops);
  // By their index; what is rock already is none.
  const std::vector<Override> kept{{7, kSoil}, {4000, kSoil}};
  CHECK(std::equal(kept.begin(), kept.end(), chunk.overrides().begin(), chunk.overrides().end()));
}

TEST_CASE("overrides that change nothing, or back, give layers") {
  const Chunk base = Chunk::from_layers({{kRock, kAir}, flat_planes({9})});
  CHECK(base.with_overrides({}).layers() != nullptr);
  const Chunk changed = base.with_overrides(std::vector<Override>{{0, kSoil}});
  CHECK(changed.with_overrides(std::vector<Override>{{0, kRock}}).layers() != nullptr);
}

TEST_CASE("overrides that make all voxels equal give a uniform chunk") {
  std::vector<std::uint8_t> top(kChunkArea, 0);
  top[5] = 2;
  const Chunk base = Chunk::from_layers({{kRock, kAir}, top});
  const Chunk chunk = base.with_overrides(std::vector<Override>{{5, kAir}, {kChunkArea + 5, kAir}});
  CHECK(chunk.is_uniform());
  CHECK(chunk == Chunk::uniform(kAir));
}

TEST_CASE("a chunk with too many overrides is dense") {
  const Chunk base = Chunk::from_layers({{kRock, kAir}, flat_planes({9})});
  std::vector<Override> overrides;
  for (std::uint16_t i = 0; i < Chunk::kMaxOverrides; ++i) overrides.push_back({i, kSoil});
  CHECK(base.with_overrides(overrides).dense() == nullptr);
  overrides.push_back({Chunk::kMaxOverrides, kSoil});
  const Chunk chunk = base.with_overrides(overrides);
  REQUIRE(chunk.dense() != nullptr);
  CHECK(chunk.at({0, 4, 0}) == kSoil);
  CHECK(chunk.with_overrides(std::vector<Override>{{0, kAir}}).at({0, 0, 0}) == kAir);
}

}  // namespace talus
