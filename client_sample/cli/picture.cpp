#include "picture.h"

#include <talus/files/atomic_file.h>
#include <talus/files/path_text.h>
#include <talus/pictures/png.h>
#include <talus/pictures/srgb.h>

namespace talus::cli {

glm::vec3 to_light(std::uint32_t rgb) {
  const auto light = [rgb](unsigned shift) {
    return pictures::light_of(static_cast<std::uint8_t>(rgb >> shift));
  };
  return {light(16), light(8), light(0)};
}

tl::expected<void, std::string> check_png_name(const std::filesystem::path& path, std::string_view option) {
  if (path.empty() || path.extension() == ".png") return {};
  return tl::unexpected{std::string{option} + " " + files::to_text(path) +
                        ": pictures are PNG; give a name that ends in .png"};
}

tl::expected<void, std::string> write_png(const Picture& picture, const std::filesystem::path& path) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(picture.pixels.size() * 3);
  for (const glm::vec3& pixel : picture.pixels) {
    for (const float channel : {pixel.r, pixel.g, pixel.b}) rgb.push_back(pictures::channel_of(channel));
  }
  const auto file = pictures::encode_png({.width = picture.width, .height = picture.height, .rgb = rgb});
  if (!file) return tl::unexpected{files::to_text(path) + ": cannot write: " + file.error()};
  return files::write_file(path, *file).map_error([](const auto& error) { return error.message(); });
}

}  // namespace talus::cli
