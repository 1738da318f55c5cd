// In place of png_heights.cpp where there is no libpng.
#include <algorithm>
#include <array>

#include "decoders.h"

namespace talus::world_files {

bool is_png(std::span<const std::byte> bytes) {
  constexpr std::array kStart{std::byte{0x89}, std::byte{'P'}, std::byte{'N'}, std::byte{'G'}};
  return bytes.size() >= kStart.size() && std::equal(kStart.begin(), kStart.end(), bytes.begin());
}

DecodeResult decode_png(std::span<const std::byte> /*bytes*/) {
  return refused("is a PNG, which this build does not read; an .npy of two axes is needed");
}

}  // namespace talus::world_files
