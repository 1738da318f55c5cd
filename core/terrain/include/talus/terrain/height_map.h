// A finite grid of heights from a file. The core does not read files; programs do.
#pragma once

#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

namespace talus::terrain {

/// Maximum side and number of samples of a height map: 256 MiB of heights.
inline constexpr int kMaxHeightMapSide = 32768;
inline constexpr std::size_t kMaxHeightMapSamples = std::size_t{1} << 26;

/// Samples in the file's units and type, z slowest, then x: samples[z * width + x].
struct HeightMap {
  int width = 0;  // along x
  int depth = 0;  // along z
  std::variant<std::vector<std::uint16_t>, std::vector<std::int32_t>, std::vector<float>,
               std::vector<std::uint8_t>, std::vector<double>>
      samples;
};

}  // namespace talus::terrain
