// A finite grid of heights from a file, and how one is found. Reading files is the business of programs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include <tl/expected.hpp>

namespace talus::terrain {

/// The longest side and the most samples of a height map: 256 MiB of heights.
inline constexpr int kMaxHeightMapSide = 32768;
inline constexpr std::size_t kMaxHeightMapSamples = std::size_t{1} << 26;

/// Samples in the numbers and the type of the file, z slowest, then x: samples[z * width + x].
struct HeightMap {
  int width = 0;  // along x
  int depth = 0;  // along z
  std::variant<std::vector<std::uint16_t>, std::vector<std::int32_t>, std::vector<float>> samples;
};

/// Gives the height map that a spec names as `file`, or says in one line why it cannot.
using LoadHeightMap = std::function<tl::expected<HeightMap, std::string>(const std::string& file)>;

}  // namespace talus::terrain
