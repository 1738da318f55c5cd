#include <talus/pictures/png.h>

#include <png.h>

namespace talus::pictures {

tl::expected<std::vector<std::byte>, std::string> encode_png(const PngImage& image) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  const void* pixels = image.rgb.data();
  png.format = PNG_FORMAT_RGB;
  if (!image.grey.empty()) {
    pixels = image.grey.data();
    png.format = PNG_FORMAT_LINEAR_Y;
  } else if (!image.indices.empty()) {
    pixels = image.indices.data();
    png.format = PNG_FORMAT_RGB_COLORMAP;
    png.colormap_entries = static_cast<png_uint_32>(image.palette.size() / 3);
  }
  // The bound for incompressible pixels; below 2^32 for every picture of at most 2^28 pixels.
  std::vector<std::byte> file(PNG_IMAGE_PNG_SIZE_MAX(png));
  png_alloc_size_t bytes = file.size();
  if (png_image_write_to_memory(&png, file.data(), &bytes, 0, pixels, 0, image.palette.data()) == 0) {
    return tl::unexpected{std::string{png.message}};
  }
  file.resize(bytes);
  return file;
}

}  // namespace talus::pictures
