// Pictures of few colours, for files a third as large.
#pragma once

#include <cstdint>
#include <vector>

#include <talus/terrain/world.h>

#include "image.h"

namespace talus::tools {

/// One byte a pixel, rows from the top.
struct PalettedImage {
  int width = 0;
  int height = 0;
  std::vector<terrain::Colour> palette;  // 1 to 256
  std::vector<std::uint8_t> pixels;
};

/// The picture in the 256 colours that come near to all of its own. The same on any machine.
[[nodiscard]] PalettedImage to_palette(const Image& image);

}  // namespace talus::tools
