#include <talus/vectors/aligned.h>

#include <catch2/catch.hpp>

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

namespace talus {
namespace {

bool aligned(const void* address) {
  return reinterpret_cast<std::uintptr_t>(address) % kVectorBytes == 0;
}

TEST_CASE("An aligned vector begins at a whole vector, whatever its size") {
  for (std::size_t size = 1; size < 300; size += 7) {
    CHECK(aligned(AlignedVector<std::uint8_t>(size).data()));
    CHECK(aligned(AlignedVector<std::int32_t>(size).data()));
  }
}

TEST_CASE("An aligned vector stays aligned and keeps its values as it grows") {
  AlignedVector<std::int16_t> values;
  for (std::int16_t i = 0; i < 5000; ++i) {
    values.push_back(i);
    REQUIRE(aligned(values.data()));
  }
  for (std::int16_t i = 0; i < 5000; ++i) REQUIRE(values[static_cast<std::size_t>(i)] == i);
}

TEST_CASE("An aligned vector that is moved gives its memory away") {
  AlignedVector<float> from(100, 1.5F);
  const float* const memory = from.data();
  const AlignedVector<float> to = std::move(from);
  CHECK(to.data() == memory);
  CHECK(to == AlignedVector<float>(100, 1.5F));
}

TEST_CASE("An aligned vector of more elements than memory can hold is an error, not a short buffer") {
  AlignedVector<std::int32_t> values;
  CHECK_THROWS_AS(values.reserve(std::numeric_limits<std::size_t>::max() / 4), std::length_error);
}

}  // namespace
}  // namespace talus
