#include <limits>
#include <unordered_set>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <talus/voxel/coords.h>

namespace talus {
namespace {

constexpr std::int64_t kFarthest = std::numeric_limits<std::int64_t>::max();

bool names(const RangeError& error, std::string_view word) {
  return error.message.find(word) != std::string::npos;
}

Lod any_lod() {
  return Lod::of(*rc::gen::inRange(0, Lod::kMax + 1));
}

std::int64_t any_chunk_number(Lod lod) {
  return *rc::gen::inRange(-chunk_limit(lod), chunk_limit(lod));
}

}  // namespace

TEST_CASE("division rounds toward minus infinity") {
  CHECK(floor_div(-1, 32) == -1);
  CHECK(floor_div(-32, 32) == -1);
  CHECK(floor_div(-33, 32) == -2);
  CHECK(floor_div(31, 32) == 0);
  CHECK(rc::check([](std::int64_t dividend) {
    const auto divisor = *rc::gen::inRange<std::int64_t>(1, 1 << 20);
    const std::int64_t remainder = floor_mod(dividend, divisor);
    RC_ASSERT(remainder >= 0);
    RC_ASSERT(remainder < divisor);
    // In unsigned numbers, where the lowest dividend cannot overflow.
    const auto back =
        static_cast<std::uint64_t>(floor_div(dividend, divisor)) * static_cast<std::uint64_t>(divisor) +
        static_cast<std::uint64_t>(remainder);
    RC_ASSERT(back == static_cast<std::uint64_t>(dividend));
  }));
}

TEST_CASE("a voxel lies at its local place in the chunk that holds it") {
  CHECK(rc::check([] {
    const Lod lod = any_lod();
    const std::int64_t limit = chunk_limit(lod) * kChunkSize;
    const auto axis = rc::gen::inRange(-limit, limit);
    const VoxelPos voxel{*axis, *axis, *axis};
    const auto key = chunk_holding(voxel, lod);
    RC_ASSERT(key.has_value());
    RC_ASSERT(key->lod == lod);
    const LocalPos local = local_pos(voxel);
    RC_ASSERT(voxel_index(local) < std::size_t{kChunkVolume});
    RC_ASSERT(to_vec(chunk_origin(key->coord)) + glm::i64vec3(local.x, local.y, local.z) == to_vec(voxel));
  }));
}

TEST_CASE("a chunk holds its own origin") {
  CHECK(rc::check([] {
    const Lod lod = any_lod();
    const auto key = checked_chunk(any_chunk_number(lod), any_chunk_number(lod), any_chunk_number(lod), lod);
    RC_ASSERT(key.has_value());
    const auto holder = chunk_holding(chunk_origin(key->coord), lod);
    RC_ASSERT(holder.has_value());
    RC_ASSERT(*holder == *key);
  }));
}

TEST_CASE("every level reaches exactly 2^31 base chunks each way") {
  for (int level = 0; level <= Lod::kMax; ++level) {
    const Lod lod = Lod::of(level);
    const std::int64_t limit = chunk_limit(lod);
    CAPTURE(level);
    CHECK(limit << level == std::int64_t{1} << 31);
    CHECK(checked_chunk(-limit, limit - 1, 0, lod).has_value());
    CHECK_FALSE(checked_chunk(limit, 0, 0, lod).has_value());
    CHECK_FALSE(checked_chunk(-limit - 1, 0, 0, lod).has_value());
    CHECK(chunk_holding({-limit * kChunkSize, limit * kChunkSize - 1, 0}, lod).has_value());
    CHECK_FALSE(chunk_holding({0, 0, limit * kChunkSize}, lod).has_value());
    CHECK_FALSE(chunk_holding({0, 0, -limit * kChunkSize - 1}, lod).has_value());
  }
}

TEST_CASE("a chunk out of range is refused by axis, value and range") {
  CHECK(checked_chunk(0, 2147483648, 0, Lod{}).error().message ==
        "chunk y is 2147483648; it must lie in -2147483648 to 2147483647 at level of detail 0");
  CHECK(names(checked_chunk(kFarthest, 0, 0, Lod{}).error(), "chunk x is 9223372036854775807"));
  CHECK(names(checked_chunk(0, 0, -kFarthest, Lod::of(6)).error(), "-33554432 to 33554431"));
}

TEST_CASE("a voxel out of range is refused by axis, value and range") {
  CHECK(chunk_holding({0, 0, 68719476736}, Lod{}).error().message ==
        "voxel z is 68719476736; it must lie in -68719476736 to 68719476735 at level of detail 0");
  CHECK(names(chunk_holding({-kFarthest - 1, 0, 0}, Lod{}).error(), "voxel x"));
  CHECK(names(chunk_holding({0, kFarthest, 0}, Lod{}).error(), "voxel y"));
}

TEST_CASE("levels of detail run from 0 to 6") {
  CHECK(Lod::checked(0) == Lod{});
  CHECK(Lod::checked(6) == Lod::of(6));
  CHECK(Lod::checked(7).error().message == "level of detail is 7; it must lie in 0 to 6");
  CHECK_FALSE(Lod::checked(-1).has_value());
  CHECK_FALSE(Lod::checked(256).has_value());
}

TEST_CASE("coordinates print themselves") {
  CHECK(to_string(ChunkCoord{-1, 0, 2147483647}) == "(-1, 0, 2147483647)");
  CHECK(to_string(ChunkKey{{1, -2, 3}, Lod::of(4)}) == "(1, -2, 3) at level of detail 4");
}

TEST_CASE("neighbouring chunks have different hashes") {
  std::unordered_set<std::size_t> hashes;
  constexpr int kReach = 8;
  for (int x = -kReach; x < kReach; ++x) {
    for (int y = -kReach; y < kReach; ++y) {
      for (int z = -kReach; z < kReach; ++z) hashes.insert(std::hash<ChunkKey>{}({{x, y, z}, Lod{}}));
    }
  }
  CHECK(hashes.size() == 8 * kReach * kReach * kReach);
}

}  // namespace talus
