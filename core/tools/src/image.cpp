#include "image.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "palette.h"

namespace talus::tools {
namespace {

float undo_curve(float channel) {
  return channel <= 0.04045F ? channel / 12.92F : std::pow((channel + 0.055F) / 1.055F, 2.4F);
}

// A table, because a power for each channel of each pixel would cost more than the terrain.
class Curve {
 public:
  Curve() {
    for (std::size_t i = 0; i < bytes_.size(); ++i) {
      const float light = static_cast<float>(i) / static_cast<float>(bytes_.size() - 1);
      const float channel =
          light <= 0.0031308F ? light * 12.92F : 1.055F * std::pow(light, 1 / 2.4F) - 0.055F;
      bytes_[i] = static_cast<std::uint8_t>(channel * 255 + 0.5F);
    }
  }
  [[nodiscard]] std::uint8_t apply(float light) const {
    const float place = std::clamp(light, 0.0F, 1.0F) * static_cast<float>(bytes_.size() - 1);
    return bytes_[static_cast<std::size_t>(place + 0.5F)];
  }

 private:
  std::array<std::uint8_t, 8192> bytes_{};
};

struct PngMemory {
  png_image image{};
  PngMemory() { image.version = PNG_IMAGE_VERSION; }
  PngMemory(const PngMemory&) = delete;
  PngMemory& operator=(const PngMemory&) = delete;
  ~PngMemory() { png_image_free(&image); }
};

Expected<void> write_pixels(files::AtomicFile& file, PngMemory& png, int width, int height,
                            const void* pixels, const std::uint8_t* palette) {
  png.image.width = static_cast<png_uint_32>(width);
  png.image.height = static_cast<png_uint_32>(height);
  // The bound for incompressible pixels passes 32 bits in no picture of at most kMaxPixels.
  std::vector<std::byte> bytes(PNG_IMAGE_PNG_SIZE_MAX(png.image));
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&png.image, bytes.data(), &size, 0, pixels, 0, palette) == 0) {
    return failed(file.target().string() + ": cannot write: " + png.image.message);
  }
  if (auto written = file.write_at(0, std::span{bytes}.first(size)); !written) return outcome_of(written);
  return outcome_of(file.commit());
}

}  // namespace

glm::vec3 to_light(terrain::Colour colour) {
  return {undo_curve(static_cast<float>(colour.red) / 255),
          undo_curve(static_cast<float>(colour.green) / 255),
          undo_curve(static_cast<float>(colour.blue) / 255)};
}

terrain::Colour to_colour(glm::vec3 light) {
  static const Curve curve;
  return {curve.apply(light.x), curve.apply(light.y), curve.apply(light.z)};
}

std::vector<glm::vec3> material_lights(const terrain::World& world) {
  std::vector<glm::vec3> lights;
  for (const terrain::Material& material : world.materials()) lights.push_back(to_light(material.colour));
  return lights;
}

Expected<void> check_picture_size(const char* option, std::int64_t width, std::int64_t height) {
  if (width <= kMaxPictureSide && height <= kMaxPictureSide && width * height <= kMaxPixels) return {};
  return wrong_use(std::string{option} + ": a picture of " + std::to_string(width) + " x " +
                   std::to_string(height) + " pixels is too large; at most " +
                   std::to_string(kMaxPictureSide) + " a side and " + std::to_string(kMaxPixels) +
                   " in all (16384 x 16384)");
}

Expected<PngFile> PngFile::create(const std::filesystem::path& target) {
  auto file = files::AtomicFile::create(target);
  if (!file) return tl::make_unexpected(file.error());
  return PngFile{std::move(*file)};
}

Expected<void> PngFile::write(const Image& image) {
  PngMemory png;
  png.image.format = PNG_FORMAT_RGB;
  return write_pixels(file_, png, image.width, image.height, image.rgb.data(), nullptr);
}

Expected<void> PngFile::write_grey(int width, int height, std::span<const std::uint16_t> samples) {
  PngMemory png;
  png.image.format = PNG_FORMAT_LINEAR_Y;
  return write_pixels(file_, png, width, height, samples.data(), nullptr);
}

Expected<void> PngFile::write(const PalettedImage& image) {
  PngMemory png;
  png.image.format = PNG_FORMAT_RGB_COLORMAP;
  png.image.colormap_entries = static_cast<png_uint_32>(image.palette.size());
  std::vector<std::uint8_t> palette;
  for (const terrain::Colour colour : image.palette) {
    palette.insert(palette.end(), {colour.red, colour.green, colour.blue});
  }
  return write_pixels(file_, png, image.width, image.height, image.pixels.data(), palette.data());
}

}  // namespace talus::tools
