// Counts what the hot path allocates: nothing, once its buffers have the size of the work.
#include <catch2/catch.hpp>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/slope.h>
#include <talus/terrain/stacks.h>
#include <talus/voxel/codec.h>

#include "features_of.h"
#include "loose/aprons.h"
#include "worlds.h"

namespace {

std::atomic<std::size_t> allocations{0};

}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc{};
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  ++allocations;
  const auto unit = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(unit, (size + unit - 1) / unit * unit)) return memory;
  throw std::bad_alloc{};
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace talus::terrain {
namespace {

void check_warm_generation(const World& world) {
  for (const int level : {0, 2}) {
    Generator generator{world};
    Stacks stacks;
    const auto patch = [&](std::int64_t x) { return Region{x, -x, 128, 128, Lod::of(level)}; };
    for (const std::int64_t x : {0, 5000, 0}) generator.generate(patch(x), stacks);
    const std::size_t before = allocations;
    generator.generate(patch(0), stacks);
    CHECK(allocations == before);
  }
}

TEST_CASE("A generator that has seen a patch generates the next without an allocation") {
  check_warm_generation(default_world());
}

TEST_CASE("Neither does one of a world with caves allocate") {
  check_warm_generation(test::small_caves(1));
}

TEST_CASE("Neither does one of a world whose features survey the ground") {
  const std::string lava =
      "[[lava]]\nname = \"lava\"\ncolour = \"#ff4010\"\nlow = 0\nhigh = 1\nspacing = 0.8\nradius = 0.3\n"
      "thickness = 0.4\nabundance = 0.8\npool_reach = 0.4\n";
  check_warm_generation(
      World::parse(test::small_world_text(1) + lava, "lava", {}, features_with_fixture()).value());
}

TEST_CASE("Aprons and cliffs of a patch need no allocation once there was one") {
  const ApronNumbers numbers{284, 179, 2048, 192, 8, 0, 12, false, {}};
  Field height{168, 168};
  for (int i = 0; i < 168; ++i) std::fill(height.row(i).begin(), height.row(i).end(), i / 20 * 5000);
  const Field slope = slope_inside(height);
  height = height.cropped(1);
  Aprons aprons{instruction_set()};
  Field raised;
  Field cliff;
  const auto compute = [&] { aprons.compute(height, slope, apron_halo(numbers), numbers, raised, cliff); };
  compute();
  CHECK(raised.values != height.cropped(apron_halo(numbers)).values);
  const std::size_t before = allocations;
  compute();
  CHECK(allocations == before);
}

TEST_CASE("A chunk that is made in another's memory is extracted and coded without an allocation") {
  // Overlays, of caves and ores, do allocate.
  const World world =
      World::parse(GENERATE(test::sample_world_text("classic"),
                            test::sample_world_without("default", {"[caves]", "[[veins]]", "[[object]]"})),
                   "sample")
          .value();
  const Stacks stacks = generate_stacks(world, {0, 0, 128, 128, Lod{}});
  Layers memory;
  std::vector<std::byte> payload;
  std::size_t mixed = 0;
  const auto make_all = [&] {
    for (std::int32_t i = 0; i < 16; ++i) {
      const std::int32_t x = i % 4;
      const std::int32_t z = i / 4;
      const MixedRange rows = mixed_range(world, stacks, x, z);
      for (std::int32_t y = rows.first; y <= rows.last; ++y) {
        Chunk chunk = extract_chunk(world, stacks, {x, y, z}, std::move(memory));
        payload.clear();
        encode(chunk, payload);
        memory = std::move(chunk).take_layers();
        ++mixed;
      }
    }
  };
  make_all();
  CHECK(mixed > 16);
  const std::size_t before = allocations;
  make_all();
  CHECK(allocations == before);
}

}  // namespace
}  // namespace talus::terrain
