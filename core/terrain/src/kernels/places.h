// Looks and shares of a row of columns, from quantities known there.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <talus/vectors/instruction_set.h>

#include "place/places.h"

namespace talus::terrain {

/// Inputs for ragged borders, one value per column; see regions.h.
struct JitterRow {
  const float* noise = nullptr;  // the borders' own noise
  const float* small = nullptr;  // noise of small hills
  const float* height = nullptr;
};

/// The minimum and maximum of a row of a quantity.
struct ValueRange {
  float low = 0;
  float high = 0;
};

struct PlaceKernels {
  /// Lowers temperature with height and adds the noise to both. All rows are padded; in place.
  void (*climate)(const JitterRow& jitter, float reciprocal_lapse, std::size_t width, float* temperature,
                  float* moisture);
  /// value += factor * noise.
  void (*jitter)(const float* noise, float factor, std::size_t width, float* values);
  /// Sets the look of the first case that holds, or 0. `quantities[q]` is a row of quantity q.
  void (*look)(std::span<const Places::Case> cases, std::span<const float* const> quantities,
               std::size_t width, std::uint8_t* looks);
  /// Returns the looks of a row: bit k is set if look k, of 64, is present.
  std::uint64_t (*present)(const std::uint8_t* looks, std::size_t width);
  /// REQUIRES width > 0.
  ValueRange (*range)(const float* values, std::size_t width);
  /// For integers of absolute value below 2^24.
  ValueRange (*range_of_int32)(const std::int32_t* values, std::size_t width);
  /// kept = share if bit looks[i] of `wanted` is set, else 0.
  void (*keep)(std::uint64_t wanted, const std::uint8_t* looks, const std::int32_t* share, std::size_t width,
               std::int32_t* kept);
  /// thinned = floor(share * ramp / kWholeShare); not in place.
  void (*thin)(const Places::Ramp& ramp, const float* values, const std::int32_t* share, std::size_t width,
               std::int32_t* thinned);
  /// thin() with a ramp of an integer quantity, such as slope.
  void (*thin_by_int32)(const Places::Ramp& ramp, const std::int32_t* values, const std::int32_t* share,
                        std::size_t width, std::int32_t* thinned);
};

[[nodiscard]] const PlaceKernels& place_kernels(InstructionSet set);

}  // namespace talus::terrain
