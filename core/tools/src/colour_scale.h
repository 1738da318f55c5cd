// Colours for numbers.
#pragma once

#include <span>
#include <string_view>

#include <talus/terrain/world.h>

namespace talus::tools {

/// Colours from the lowest number to the highest, evenly apart and mixed between.
struct ColourScale {
  std::span<const terrain::Colour> colours;
  /// `part`: 0 to 1, clamped.
  [[nodiscard]] terrain::Colour at(float part) const;
};

/// That of a quantity or field by its name (places.h); of unknown ones, one that is pale in the middle.
[[nodiscard]] ColourScale scale_of(std::string_view name);
/// That of a height between the lowest and the highest; heights below 0 are under water where there is a sea.
[[nodiscard]] terrain::Colour colour_of_height(float height, float low, float high, bool sea);

}  // namespace talus::tools
