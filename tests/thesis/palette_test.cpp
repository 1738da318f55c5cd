#include "palette.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <catch2/catch.hpp>

using namespace talus;
using namespace talus::tools;

namespace {

Image gradient(int width, int height) {
  Image image{width, height};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.set(x, y,
                {static_cast<std::uint8_t>(x * 255 / width), static_cast<std::uint8_t>(y * 255 / height),
                 static_cast<std::uint8_t>(128)});
    }
  }
  return image;
}

terrain::Colour colour_at(const PalettedImage& image, int x, int y) {
  return image.palette[image.pixels[static_cast<std::size_t>(y * image.width + x)]];
}

}  // namespace

TEST_CASE("A picture of few colours keeps them") {
  Image image{16, 16};
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      image.set(x, y,
                {static_cast<std::uint8_t>(x * 16), static_cast<std::uint8_t>(y * 16),
                 static_cast<std::uint8_t>((x + y) * 8)});
    }
  }
  const PalettedImage paletted = to_palette(image);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) CHECK(colour_at(paletted, x, y) == image.at(x, y));
  }
}

TEST_CASE("A picture of many colours comes near to all of them with 256") {
  const Image image = gradient(200, 150);
  const PalettedImage paletted = to_palette(image);
  CHECK(paletted.palette.size() == 256);
  int farthest = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const terrain::Colour was = image.at(x, y);
      const terrain::Colour is = colour_at(paletted, x, y);
      farthest = std::max({farthest, std::abs(was.red - is.red), std::abs(was.green - is.green),
                           std::abs(was.blue - is.blue)});
    }
  }
  CHECK(farthest <= 16);
}

TEST_CASE("A picture of one colour has a palette of one") {
  const PalettedImage paletted = to_palette(Image{5, 4});
  CHECK(paletted.palette.size() == 1);
  CHECK(paletted.pixels.size() == 20);
}
