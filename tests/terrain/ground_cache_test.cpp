// Ground that patches share: whatever is in the cache, the voxels are the same.
#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include <talus/terrain/generator.h>
#include <talus/terrain/ground_cache.h>
#include <talus/terrain/stacks.h>

#include "surface/ground_tiles.h"
#include "worlds.h"

namespace talus::terrain {
namespace {

bool same_objects(const Stacks& a, const Stacks& b) {
  const auto all = [](const Stacks& stacks) {
    std::vector<std::tuple<int, std::int64_t, std::int64_t, std::int64_t, std::uint64_t>> objects;
    for (const PlacedObject& o : stacks.objects) objects.emplace_back(o.kind, o.x, o.y, o.z, o.hash);
    return objects;
  };
  return all(a) == all(b);
}

bool same(const Stacks& a, const Stacks& b) {
  if (a.materials != b.materials || a.tops.size() != b.tops.size() || a.looks.size() != b.looks.size())
    return false;
  for (std::size_t i = 0; i < a.tops.size(); ++i) {
    if (a.tops[i].values != b.tops[i].values) return false;
  }
  for (std::size_t i = 0; i < a.looks.size(); ++i) {
    if (a.looks[i].values != b.looks[i].values) return false;
  }
  return a.caves.floor.values == b.caves.floor.values && a.caves.roof.values == b.caves.roof.values &&
         same_objects(a, b);
}

/// Near each other, so that they share ground; of columns of level 0 on and beside the edges of its tiles.
Region any_region() {
  const int level = *rc::gen::element(0, 0, 0, 1, 2, 4);
  return {*rc::gen::inRange<std::int64_t>(-2100, -1900) >> level,
          *rc::gen::inRange<std::int64_t>(-6300, -6100) >> level, *rc::gen::inRange(1, 70),
          *rc::gen::inRange(1, 70), Lod::of(level)};
}

TEST_CASE("Stacks do not depend on what a cache of ground holds, nor on its size") {
  CHECK(rc::check([] {
    const std::string name = *rc::gen::element<std::string>("default", "mesas", "classic");
    const World& world = test::sample_world(name);
    const auto cache = std::make_shared<GroundCache>(
        *rc::gen::element<std::size_t>(0, 20'000, 200'000, std::size_t{1} << 24));
    std::vector<Generator> generators;
    for (int i = 0; i < 2; ++i) generators.emplace_back(world, cache);
    Stacks stacks;
    for (int round = 0; round < 4; ++round) {
      const Region region = any_region();
      generators[*rc::gen::inRange<std::size_t>(0, 2)].generate(region, stacks);
      RC_ASSERT(same(stacks, generate_stacks(world, region)));
    }
  }));
}

TEST_CASE("Ground that is in the cache is not computed again") {
  const World& world = test::sample_world("default");
  const auto cache = std::make_shared<GroundCache>(std::size_t{1} << 24);
  Generator generator{world, cache};
  Stacks stacks;
  const Region region{-2000, -6200, 32, 32, Lod{}};
  const auto pieces = [&] {
    generator.start(region, std::move(stacks));
    int count = 1;
    while (generator.step(1)) ++count;
    stacks = generator.take();
    return count;
  };
  const int cold = pieces();
  const std::size_t bytes = cache->bytes();
  CHECK(bytes > 0);
  CHECK(pieces() < cold - 64);  // its rows
  CHECK(cache->bytes() == bytes);
}

TEST_CASE("A cache keeps the tiles that were used last, and no more than it may") {
  GroundTiles tiles{20'000};
  const auto tile_of = [](std::int32_t height) {
    auto tile = std::make_shared<GroundTile>();
    tile->heights_fx.fill(height);
    return tile;
  };
  const auto find = [&](std::int64_t x) {
    const GroundTileKey key{x, 0, 0};
    GroundTilePtr found;
    tiles.find({&key, 1}, {&found, 1});
    return found;
  };
  for (std::int32_t x = 0; x < 100; ++x) {
    tiles.put({x, 0, 0}, tile_of(x));
    CHECK(tiles.bytes() <= 20'000);
    REQUIRE(find(0) != nullptr);  // so that it is used
    CHECK(find(0)->heights_fx.front() == 0);
  }
  CHECK(find(1) == nullptr);
  CHECK(find(99)->heights_fx.front() == 99);
  const GroundTileKey other_level{99, 0, 1};
  GroundTilePtr found;
  tiles.find({&other_level, 1}, {&found, 1});
  CHECK(found == nullptr);
}

class MutexLock final : public GroundLock {
 public:
  void lock() override { mutex_.lock(); }
  void unlock() override { mutex_.unlock(); }

 private:
  std::mutex mutex_;
};

TEST_CASE("Threads share a cache of ground that has a lock") {
  const World& world = test::sample_world("default");
  const auto cache = std::make_shared<GroundCache>(200'000, std::make_unique<MutexLock>());
  std::vector<Region> regions;
  for (int i = 0; i < 6; ++i) regions.push_back({-2000 + 20 * i, -6200 + 30 * (i % 2), 40, 40, Lod{}});
  std::vector<std::vector<Stacks>> made(2);
  std::vector<std::thread> threads;
  for (auto& stacks : made) {
    threads.emplace_back([&] {
      Generator generator{world, cache};
      for (const Region& region : regions) generator.generate(region, stacks.emplace_back());
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const Stacks alone = generate_stacks(world, regions[i]);
    for (const auto& stacks : made) CHECK(same(stacks[i], alone));
  }
}

}  // namespace
}  // namespace talus::terrain
