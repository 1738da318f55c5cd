#include "colour_scale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace talus::tools {
namespace {

using ScaleColour = terrain::Colour;

constexpr std::array kEven{ScaleColour{44, 62, 98}, ScaleColour{111, 138, 170}, ScaleColour{238, 234, 222},
                           ScaleColour{202, 142, 86}, ScaleColour{128, 66, 34}};
constexpr std::array kHeat{ScaleColour{52, 76, 138}, ScaleColour{126, 166, 200}, ScaleColour{240, 233, 212},
                           ScaleColour{226, 146, 84}, ScaleColour{158, 46, 44}};
constexpr std::array kWet{ScaleColour{150, 104, 48}, ScaleColour{212, 178, 112}, ScaleColour{240, 236, 218},
                          ScaleColour{118, 178, 164}, ScaleColour{22, 98, 106}};
constexpr std::array kMuch{ScaleColour{242, 238, 226}, ScaleColour{222, 190, 150}, ScaleColour{178, 104, 72},
                           ScaleColour{92, 40, 48}};
constexpr std::array kPeaks{ScaleColour{242, 238, 226}, ScaleColour{186, 190, 196},
                            ScaleColour{110, 118, 138}, ScaleColour{42, 46, 70}};
constexpr std::array kDepths{ScaleColour{24, 48, 88}, ScaleColour{52, 98, 148}, ScaleColour{130, 178, 206}};
constexpr std::array kElevations{ScaleColour{112, 150, 98},  ScaleColour{150, 176, 112},
                                 ScaleColour{198, 196, 138}, ScaleColour{204, 166, 112},
                                 ScaleColour{160, 118, 92},  ScaleColour{176, 166, 162},
                                 ScaleColour{252, 252, 252}};

}  // namespace

terrain::Colour ColourScale::at(float part) const {
  const float place = std::clamp(part, 0.0F, 1.0F) * static_cast<float>(colours.size() - 1);
  const std::size_t low = std::min(static_cast<std::size_t>(place), colours.size() - 2);
  const float t = place - static_cast<float>(low);
  const auto mixed = [&](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(
        std::lround(static_cast<float>(from) + t * static_cast<float>(to - from)));
  };
  const terrain::Colour a = colours[low];
  const terrain::Colour b = colours[low + 1];
  return {mixed(a.red, b.red), mixed(a.green, b.green), mixed(a.blue, b.blue)};
}

ColourScale scale_of(std::string_view name) {
  if (name == "temperature") return {kHeat};
  if (name == "moisture") return {kWet};
  if (name == "mesas" || name == "terraces") return {kMuch};
  if (name == "ranges") return {kPeaks};
  return {kEven};
}

terrain::Colour colour_of_height(float height, float low, float high, bool sea) {
  if (sea && height < 0) return ColourScale{kDepths}.at(1 - height / std::min(low, -1.0F));
  const float bottom = sea ? std::max(low, 0.0F) : low;
  // Most land is low.
  return ColourScale{kElevations}.at(std::sqrt((height - bottom) / std::max(high - bottom, 1e-3F)));
}

}  // namespace talus::tools
