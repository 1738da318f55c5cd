#include <talus/pictures/png.h>
#include <talus/pictures/srgb.h>

#include <png.h>

#include <array>

#include <catch2/catch.hpp>

using namespace talus::pictures;

namespace {

/// The picture as libpng reads it.
template <typename Sample>
std::vector<Sample> decoded(const std::vector<std::byte>& file, png_uint_32 format, std::size_t samples) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_memory(&image, file.data(), file.size()) != 0);
  image.format = format;
  std::vector<Sample> pixels(samples);
  REQUIRE(PNG_IMAGE_SIZE(image) == samples * sizeof(Sample));
  REQUIRE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr) != 0);
  return pixels;
}

}  // namespace

TEST_CASE("a channel's light comes back as that channel") {
  for (int channel = 0; channel < 256; ++channel) {
    CHECK(channel_of(light_of(static_cast<std::uint8_t>(channel))) == channel);
  }
}

TEST_CASE("light grows with the channel, from zero to all") {
  CHECK(light_of(0) == 0);
  CHECK(light_of(255) == 1);
  CHECK(light_of(188) == Approx(0.5).margin(0.01));  // half the light is far more than half the channel
  for (int channel = 1; channel < 256; ++channel) {
    CHECK(light_of(static_cast<std::uint8_t>(channel)) > light_of(static_cast<std::uint8_t>(channel - 1)));
  }
}

TEST_CASE("light beyond its range is clamped") {
  CHECK(channel_of(-1) == 0);
  CHECK(channel_of(7) == 255);
}

TEST_CASE("pixels of each kind come back from their file") {
  const std::vector<std::uint8_t> rgb{1, 2, 3, 250, 251, 252};
  CHECK(decoded<std::uint8_t>(*encode_png({.width = 2, .height = 1, .rgb = rgb}), PNG_FORMAT_RGB, 6) == rgb);
  const std::vector<std::uint16_t> grey{0, 1, 65535};
  CHECK(decoded<std::uint16_t>(*encode_png({.width = 1, .height = 3, .grey = grey}), PNG_FORMAT_LINEAR_Y,
                               3) == grey);
  const std::vector<std::uint8_t> indices{1, 0};
  const std::vector<std::uint8_t> palette{9, 8, 7, 40, 50, 60};
  CHECK(decoded<std::uint8_t>(*encode_png({.width = 2, .height = 1, .indices = indices, .palette = palette}),
                              PNG_FORMAT_RGB, 6) == std::vector<std::uint8_t>{40, 50, 60, 9, 8, 7});
}

TEST_CASE("a picture that cannot be a PNG is an error") {
  CHECK_FALSE(encode_png({}).has_value());
}
