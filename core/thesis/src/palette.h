// Reduces pictures to few colours, for files a third as large.
#pragma once

#include <cstdint>
#include <vector>

#include <talus/terrain/world.h>
#include <talus/tools/image.h>

namespace talus::tools {

/// One byte per pixel, rows from the top.
struct PalettedImage {
  int width = 0;
  int height = 0;
  std::vector<terrain::Colour> palette;  // 1 to 256
  std::vector<std::uint8_t> pixels;
};

/// Approximates the picture with 256 colours. The result is the same on every machine.
[[nodiscard]] PalettedImage to_palette(const Image& image);

[[nodiscard]] Expected<void> write(PngFile& file, const PalettedImage& image);

}  // namespace talus::tools
