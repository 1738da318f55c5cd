#include <talus/edits/levels.h>

#include <array>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

namespace talus::edits {
namespace {

constexpr std::int64_t kWorldEnd = std::int64_t{1} << 36;

std::int64_t any_coordinate() {
  const auto middle = *rc::gen::element<std::int64_t>(0, -kWorldEnd + 200, kWorldEnd - 200);
  return middle + *rc::gen::inRange<std::int64_t>(-200, 200);
}

/// Rule 1 as it is written.
bool is_sample(VoxelPos voxel, int level) {
  const std::int64_t size = std::int64_t{1} << level;
  return floor_mod(voxel.x, size) == 0 && floor_mod(voxel.z, size) == 0 &&
         floor_mod(voxel.y, size) == size / 2;
}

}  // namespace

TEST_CASE("a voxel is the sample that rule 1 says, of at most one level") {
  CHECK(rc::check([] {
    // Multiples of 2^n are drawn often, for they are what samples are made of.
    const std::int64_t step = std::int64_t{1} << *rc::gen::inRange(0, 8);
    const auto at = [&](std::int64_t coordinate) { return floor_div(coordinate, step) * step; };
    const std::int64_t y = any_coordinate();
    const VoxelPos voxel{at(any_coordinate()), floor_div(y, step) * step + step / 2, at(any_coordinate())};
    const auto coarse = sampled_by(voxel);
    int levels = 0;
    for (int level = 1; level <= Lod::kMax; ++level) {
      if (!is_sample(voxel, level)) continue;
      ++levels;
      const std::int64_t size = std::int64_t{1} << level;
      RC_ASSERT(coarse.has_value());
      RC_ASSERT(coarse->lod == Lod::of(level));
      RC_ASSERT(coarse->voxel ==
                (VoxelPos{floor_div(voxel.x, size), floor_div(voxel.y, size), floor_div(voxel.z, size)}));
    }
    RC_ASSERT(levels == (coarse ? 1 : 0));
  }));
}

TEST_CASE("every voxel of every level has its sample, at the world's ends too") {
  for (int level = 1; level <= Lod::kMax; ++level) {
    const Lod lod = Lod::of(level);
    const std::int64_t end = chunk_limit(lod) * kChunkSize;
    for (const std::int64_t x : {-end, std::int64_t{-1}, std::int64_t{0}, end - 1}) {
      for (const std::int64_t y : {-end, std::int64_t{-1}, std::int64_t{0}, end - 1}) {
        const VoxelPos voxel{x, y, -1 - x};
        const VoxelPos sample = sample_of(lod, voxel);
        CAPTURE(level, x, y);
        CHECK(chunk_holding(sample, Lod{}).has_value());
        CHECK(sampled_by(sample) == CoarseVoxel{lod, voxel});
      }
    }
  }
}

TEST_CASE("one voxel in eight of level 1, and one in eight of each level of the level before") {
  std::array<int, Lod::kMax + 1> counts{};
  for (std::int64_t y = -64; y < 64; ++y) {
    for (std::int64_t z = -64; z < 64; ++z) {
      for (std::int64_t x = -64; x < 64; ++x) {
        if (const auto coarse = sampled_by({x, y, z}))
          ++counts[static_cast<std::size_t>(coarse->lod.value())];
      }
    }
  }
  int expected = 128 * 128 * 128;
  for (std::size_t level = 1; level < counts.size(); ++level) CHECK(counts[level] == (expected /= 8));
}

TEST_CASE("writes to a base chunk reach one chunk of each level") {
  // Voxel (0, 1, 0) of chunk (-1, -1, -1) is (-32, -31, -32): level 1, voxel (-16, -16, -16).
  const std::uint16_t above = 1 * kChunkArea;
  const std::uint16_t two = 2 * kChunkArea;
  const std::vector<OverrideWrite> writes{
      {0, MaterialId{4}}, {above, MaterialId{5}}, {above + 1, MaterialId{6}}, {two, std::nullopt}};
  const auto coarse = coarse_writes({-1, -1, -1}, writes);
  REQUIRE(coarse.size() == 2);
  CHECK(coarse[0].key == ChunkKey{{-1, -1, -1}, Lod::of(1)});
  const auto index = [](std::uint8_t at) { return static_cast<std::uint16_t>(voxel_index({at, at, at})); };
  CHECK(coarse[0].writes == std::vector<OverrideWrite>{{index(16), MaterialId{5}}});
  CHECK(coarse[1].key == ChunkKey{{-1, -1, -1}, Lod::of(2)});
  CHECK(coarse[1].writes == std::vector<OverrideWrite>{{index(24), std::nullopt}});
}

TEST_CASE("the rule's number is 1: another rule takes another number") {
  CHECK(kLevelRule == 1);
}

}  // namespace talus::edits
