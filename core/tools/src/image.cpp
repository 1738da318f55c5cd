#include "image.h"

#include <string>
#include <utility>

#include <talus/pictures/png.h>
#include <talus/pictures/srgb.h>

#include "palette.h"

namespace talus::tools {
namespace {

Expected<void> write_image(files::AtomicFile& file, const pictures::PngImage& image) {
  const auto bytes = pictures::encode_png(image);
  if (!bytes) return failed(file.target().string() + ": cannot write: " + bytes.error());
  if (auto written = file.write_at(0, *bytes); !written) return outcome_of(written);
  return outcome_of(file.commit());
}

}  // namespace

glm::vec3 to_light(terrain::Colour colour) {
  return {pictures::light_of(colour.red), pictures::light_of(colour.green), pictures::light_of(colour.blue)};
}

terrain::Colour to_colour(glm::vec3 light) {
  return {pictures::channel_of(light.x), pictures::channel_of(light.y), pictures::channel_of(light.z)};
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
  return write_image(file_, {.width = image.width, .height = image.height, .rgb = image.rgb});
}

Expected<void> PngFile::write_grey(int width, int height, std::span<const std::uint16_t> samples) {
  return write_image(file_, {.width = width, .height = height, .grey = samples});
}

Expected<void> PngFile::write(const PalettedImage& image) {
  std::vector<std::uint8_t> palette;
  for (const terrain::Colour colour : image.palette) {
    palette.insert(palette.end(), {colour.red, colour.green, colour.blue});
  }
  return write_image(
      file_, {.width = image.width, .height = image.height, .indices = image.pixels, .palette = palette});
}

}  // namespace talus::tools
