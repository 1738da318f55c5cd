// Looks and shares of a row of columns, by quantities that are known there.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <talus/vectors/instruction_set.h>

#include "place/places.h"

namespace talus::terrain {

/// What borders are made ragged by and with, a value a column: regions.h says what each is.
struct JitterRow {
  const float* noise = nullptr;  // the border's own
  const float* small = nullptr;  // of small hills
  const float* height = nullptr;
};

/// Between which values a row of a quantity lies.
struct ValueRange {
  float low = 0;
  float high = 0;
};

struct PlaceKernels {
  /// temperature, moisture: falls with height, and both get the noise. All padded; in place.
  void (*climate)(const JitterRow& jitter, float reciprocal_lapse, std::size_t width, float* temperature,
                  float* moisture);
  /// value += factor * noise.
  void (*jitter)(const float* noise, float factor, std::size_t width, float* values);
  /// The look of the first case that holds, or 0. `quantities[q]` is a row of quantity q.
  void (*look)(std::span<const Places::Case> cases, std::span<const float* const> quantities,
               std::size_t width, std::uint8_t* looks);
  /// Which of 64 looks a row has: bit k where look k.
  std::uint64_t (*present)(const std::uint8_t* looks, std::size_t width);
  /// REQUIRES width > 0.
  ValueRange (*range)(const float* values, std::size_t width);
  /// The same of integers less than 2^24 either way.
  ValueRange (*range_of_int32)(const std::int32_t* values, std::size_t width);
  /// kept = share where bit looks[i] of `wanted` is set, else 0.
  void (*keep)(std::uint64_t wanted, const std::uint8_t* looks, const std::int32_t* share, std::size_t width,
               std::int32_t* kept);
  /// thinned = floor(share * ramp / kWholeShare); not in place.
  void (*thin)(const Places::Ramp& ramp, const float* values, const std::int32_t* share, std::size_t width,
               std::int32_t* thinned);
  /// The same with a ramp of integers, as slope is.
  void (*thin_by_int32)(const Places::Ramp& ramp, const std::int32_t* values, const std::int32_t* share,
                        std::size_t width, std::int32_t* thinned);
};

[[nodiscard]] const PlaceKernels& place_kernels(InstructionSet set);

}  // namespace talus::terrain
