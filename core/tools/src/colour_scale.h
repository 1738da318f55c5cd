// Maps numbers to colours.
#pragma once

#include <span>
#include <string_view>

#include <talus/terrain/world.h>

namespace talus::tools {

/// Colours from the lowest to the highest number, equidistant, with interpolation.
struct ColourScale {
  std::span<const terrain::Colour> colours;
  /// `part`: 0 to 1, clamped.
  [[nodiscard]] terrain::Colour at(float part) const;
};

/// The scale of a quantity or field by name (places.h); for unknown names, one pale in the middle.
[[nodiscard]] ColourScale scale_of(std::string_view name);
/// Colour of a height between the lowest and the highest; heights below 0 are under water if `sea` is set.
[[nodiscard]] terrain::Colour colour_of_height(float height, float low, float high, bool sea);

}  // namespace talus::tools
