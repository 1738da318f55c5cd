#include <talus/tools/image.h>

#include <string>
#include <utility>

#include <talus/files/path_text.h>

namespace talus::tools {

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
  return write(pictures::PngImage{.width = image.width, .height = image.height, .rgb = image.rgb});
}

Expected<void> PngFile::write(const pictures::PngImage& image) {
  const auto bytes = pictures::encode_png(image);
  if (!bytes) return failed(files::to_text(file_.target()) + ": cannot write: " + bytes.error());
  if (auto written = file_.write_at(0, *bytes); !written) return outcome_of(written);
  return outcome_of(file_.commit());
}

}  // namespace talus::tools
