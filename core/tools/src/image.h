// Pictures: pixels, colours as light, and PNG files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include <talus/terrain/world.h>
#include <glm/vec3.hpp>

#include <talus/files/atomic_file.h>

#include "failure.h"

namespace talus::tools {

/// The most pixels that a picture may have: 768 MiB of memory.
inline constexpr std::int64_t kMaxPixels = std::int64_t{1} << 28;
inline constexpr std::int64_t kMaxPictureSide = 1 << 16;

/// RGB, 8 bits a channel, rows from the top. Threads may set different pixels at once.
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

/// Amounts of light, in which colours may be mixed and lit: sRGB with its curve undone, 0 to 1.
[[nodiscard]] glm::vec3 to_light(terrain::Colour colour);
/// Clamps values outside 0 to 1.
[[nodiscard]] terrain::Colour to_colour(glm::vec3 light);

/// The colour of every material of a world as light, by id.
[[nodiscard]] std::vector<glm::vec3> material_lights(const terrain::World& world);

/// Refuses what has more than kMaxPixels or a side over kMaxPictureSide; `option` names the source.
[[nodiscard]] Expected<void> check_picture_size(const char* option, std::int64_t width, std::int64_t height);

struct PalettedImage;

/// A PNG file that has no name yet. Create it before the picture is drawn: a path that cannot be written is
/// an error at once.
class PngFile {
 public:
  [[nodiscard]] static Expected<PngFile> create(const std::filesystem::path& target);
  /// Writes the whole file, then gives it its name.
  [[nodiscard]] Expected<void> write(const Image& image);
  [[nodiscard]] Expected<void> write(const PalettedImage& image);
  /// The same for grey samples of 16 bits, which are written unchanged.
  [[nodiscard]] Expected<void> write_grey(int width, int height, std::span<const std::uint16_t> samples);

 private:
  explicit PngFile(files::AtomicFile file) : file_{std::move(file)} {}
  files::AtomicFile file_;
};

}  // namespace talus::tools
