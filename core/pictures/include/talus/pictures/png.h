// Encodes PNG files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace talus::pictures {

/// Pixels in rows from the top. Refers to the caller's memory; width and height are at least 1.
struct PngImage {
  int width = 0;
  int height = 0;
  /// Exactly one is set: 8-bit red, green and blue; 16-bit samples; or indexes into the palette.
  std::span<const std::uint8_t> rgb{};
  std::span<const std::uint16_t> grey{};
  std::span<const std::uint8_t> indices{};
  std::span<const std::uint8_t> palette{};  // red, green and blue of up to 256 colours
};

/// Returns the complete file, or libpng's error.
[[nodiscard]] tl::expected<std::vector<std::byte>, std::string> encode_png(const PngImage& image);

}  // namespace talus::pictures
