// PNG files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace talus::pictures {

/// Pixels in rows from the top. Views of the caller's memory; width and height are at least 1.
struct PngImage {
  int width = 0;
  int height = 0;
  /// One of them: red, green and blue of 8 bits a pixel; a sample of 16 bits; or an index into the palette.
  std::span<const std::uint8_t> rgb{};
  std::span<const std::uint16_t> grey{};
  std::span<const std::uint8_t> indices{};
  std::span<const std::uint8_t> palette{};  // red, green and blue of up to 256 colours
};

/// The whole file, or libpng's words.
[[nodiscard]] tl::expected<std::vector<std::byte>, std::string> encode_png(const PngImage& image);

}  // namespace talus::pictures
