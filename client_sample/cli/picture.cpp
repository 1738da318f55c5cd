#include "picture.h"

#include <png.h>

#include <cmath>
#include <span>

#include <glm/common.hpp>

#include <talus/files/atomic_file.h>

namespace talus::cli {
namespace {

float to_linear(std::uint32_t byte) {
  const float value = static_cast<float>(byte) / 255.0F;
  return value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
}

std::uint8_t to_srgb(float light) {
  const float value = glm::clamp(light, 0.0F, 1.0F);
  const float curved = value <= 0.0031308F ? value * 12.92F : 1.055F * std::pow(value, 1.0F / 2.4F) - 0.055F;
  return static_cast<std::uint8_t>(curved * 255.0F + 0.5F);
}

}  // namespace

glm::vec3 to_light(std::uint32_t rgb) {
  return {to_linear((rgb >> 16U) & 0xFFU), to_linear((rgb >> 8U) & 0xFFU), to_linear(rgb & 0xFFU)};
}

tl::expected<void, std::string> write_png(const Picture& picture, const std::filesystem::path& path) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(picture.pixels.size() * 3);
  for (const glm::vec3& pixel : picture.pixels) {
    for (const float channel : {pixel.r, pixel.g, pixel.b}) rgb.push_back(to_srgb(channel));
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t bytes = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::vector<std::byte> file(bytes);
  if (png_image_write_to_memory(&image, file.data(), &bytes, 0, rgb.data(), 0, nullptr) == 0) {
    return tl::unexpected{path.string() + ": the picture cannot be encoded: " + image.message};
  }
  return files::write_file(path, std::span{file}.first(bytes)).map_error([](const auto& error) {
    return error.message();
  });
}

}  // namespace talus::cli
