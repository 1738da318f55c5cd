// Writes pictures as PNG files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <utility>

#include <talus/files/atomic_file.h>
#include <talus/map/image.h>
#include <talus/map/light.h>
#include <talus/pictures/png.h>
#include <talus/tools/failure.h>

namespace talus::tools {

/// Maximum pixels of a picture: 768 MiB of memory.
inline constexpr std::int64_t kMaxPixels = std::int64_t{1} << 28;
inline constexpr std::int64_t kMaxPictureSide = 1 << 16;

using map::Image;
using map::material_lights;
using map::to_colour;
using map::to_light;

/// Rejects more than kMaxPixels, or a side above kMaxPictureSide; `option` names the source in the error.
[[nodiscard]] Expected<void> check_picture_size(const char* option, std::int64_t width, std::int64_t height);

/// A PNG file without a name yet. Create it before drawing, so that a path that cannot be written fails at
/// once.
class PngFile {
 public:
  [[nodiscard]] static Expected<PngFile> create(const std::filesystem::path& target);
  /// Writes the complete file, then renames it into place.
  [[nodiscard]] Expected<void> write(const Image& image);
  [[nodiscard]] Expected<void> write(const pictures::PngImage& image);

 private:
  explicit PngFile(files::AtomicFile file) : file_{std::move(file)} {}
  files::AtomicFile file_;
};

}  // namespace talus::tools
