// An RGB image.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <talus/terrain/world.h>

namespace talus::map {

/// 8 bits per channel, rows from the top. Different threads may set different pixels concurrently.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;

  Image(int width_, int height_)
      : width{width_},
        height{height_},
        rgb(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 3) {}

  [[nodiscard]] terrain::Colour at(int x, int y) const {
    const std::uint8_t* pixel = rgb.data() + offset(x, y);
    return {pixel[0], pixel[1], pixel[2]};
  }
  void set(int x, int y, terrain::Colour colour) {
    std::uint8_t* pixel = rgb.data() + offset(x, y);
    pixel[0] = colour.red;
    pixel[1] = colour.green;
    pixel[2] = colour.blue;
  }

 private:
  [[nodiscard]] std::size_t offset(int x, int y) const {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) * 3;
  }
};

}  // namespace talus::map
