// Pictures: pixels as linear light, and PNG files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>
#include <tl/expected.hpp>

namespace talus::cli {

/// Linear light, 0 to 1 per channel or above, rows from the top.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<glm::vec3> pixels;

  Picture(int width_, int height_)
      : width{width_},
        height{height_},
        pixels(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}

  [[nodiscard]] glm::vec3& at(int x, int y) { return pixels[index(x, y)]; }
  [[nodiscard]] const glm::vec3& at(int x, int y) const { return pixels[index(x, y)]; }

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

/// Converts sRGB 0xRRGGBB to linear light.
[[nodiscard]] glm::vec3 to_light(std::uint32_t rgb);

/// Fails unless `path` is empty or ends in .png; the error names `option`.
[[nodiscard]] tl::expected<void, std::string> check_png_name(const std::filesystem::path& path,
                                                             std::string_view option);

/// Writes 8-bit sRGB. The error is one line that names the file.
[[nodiscard]] tl::expected<void, std::string> write_png(const Picture& picture,
                                                        const std::filesystem::path& path);

}  // namespace talus::cli
