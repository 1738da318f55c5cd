#include "image.h"

#include <string>
#include <utility>

#include <talus/pictures/png.h>

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
