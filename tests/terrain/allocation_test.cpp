// Counts what the hot path allocates: nothing, once its buffers have the size of the work.
#include <catch2/catch.hpp>

#include <atomic>
#include <cstdlib>
#include <new>

#include <talus/terrain/stacks.h>

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

}  // namespace
}  // namespace talus::terrain
