// Reads unmodified samples: libpng's simplified interface would apply the file's gamma to them.
#include <png.h>

#include <algorithm>
#include <array>
#include <bit>
#include <csetjmp>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "decoders.h"

namespace talus::world_files {
namespace {

struct Source {
  std::span<const std::byte> rest;
  std::array<char, 128> complaint{};
};

void give_bytes(png_structp png, png_bytep out, std::size_t count) {
  auto& source = *static_cast<Source*>(png_get_io_ptr(png));
  if (count > source.rest.size()) png_error(png, "the file ends early");
  std::memcpy(out, source.rest.data(), count);
  source.rest = source.rest.subspan(count);
}

[[noreturn]] void stop(png_structp png, png_const_charp why) {
  auto& source = *static_cast<Source*>(png_get_error_ptr(png));
  std::strncpy(source.complaint.data(), why, source.complaint.size() - 1);
  png_longjmp(png, 1);
}

void ignore(png_structp, png_const_charp) {}

class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : source_{bytes} {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &source_, stop, ignore);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() { png_destroy_read_struct(&png_, &info_, nullptr); }

  // libpng leaves these two functions by longjmp: no object with a destructor may live in them.
  bool read_header() {
    if (info_ == nullptr) return false;
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_read_fn(png_, &source_, give_bytes);
    png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // ours are checked before rows are read
    png_read_info(png_, info_);
    return true;
  }
  template <class Sample>
  bool read_rows(Sample* samples) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    if constexpr (sizeof(Sample) == 2 && std::endian::native == std::endian::little) png_set_swap(png_);
    const int passes = png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    const std::size_t width = png_get_image_width(png_, info_);
    const std::size_t depth = png_get_image_height(png_, info_);
    for (int pass = 0; pass < passes; ++pass) {
      for (std::size_t z = 0; z < depth; ++z) {
        png_read_row(png_, reinterpret_cast<png_bytep>(samples + z * width), nullptr);
      }
    }
    png_read_end(png_, nullptr);
    return true;
  }

  [[nodiscard]] std::string complaint() const { return source_.complaint.data(); }
  [[nodiscard]] std::uint64_t width() const { return png_get_image_width(png_, info_); }
  [[nodiscard]] std::uint64_t depth() const { return png_get_image_height(png_, info_); }
  [[nodiscard]] int bit_depth() const { return png_get_bit_depth(png_, info_); }
  [[nodiscard]] bool grey() const { return png_get_color_type(png_, info_) == PNG_COLOR_TYPE_GRAY; }
  [[nodiscard]] std::string_view colours() const {
    switch (png_get_color_type(png_, info_)) {
      case PNG_COLOR_TYPE_GRAY:
        return "grey";
      case PNG_COLOR_TYPE_GRAY_ALPHA:
        return "grey and alpha";
      case PNG_COLOR_TYPE_PALETTE:
        return "a palette";
      case PNG_COLOR_TYPE_RGB:
        return "RGB";
      default:
        return "RGBA";
    }
  }
  /// The sample of transparent pixels, which mark missing data; nullopt if all pixels are visible.
  [[nodiscard]] std::optional<std::uint16_t> transparent() const {
    png_color_16p value = nullptr;
    if (png_get_tRNS(png_, info_, nullptr, nullptr, &value) == 0 || value == nullptr) return std::nullopt;
    return value->gray;
  }

 private:
  Source source_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

template <class Sample>
DecodeResult map_of(Reader& reader) {
  std::vector<Sample> samples(reader.width() * reader.depth());
  if (!reader.read_rows(samples.data())) return refused("is not a whole PNG: " + reader.complaint());
  const auto none = reader.transparent();
  const auto hole = none ? std::find(samples.begin(), samples.end(), *none) : samples.end();
  if (hole != samples.end()) {
    const auto place = static_cast<std::size_t>(hole - samples.begin());
    return refused("has a transparent sample, which marks missing data: " + std::to_string(*none) +
                   ", as sample " + std::to_string(place % reader.width()) + " of row " +
                   std::to_string(place / reader.width()) + "; fill it, or write the file without tRNS");
  }
  terrain::HeightMap map;
  map.width = static_cast<int>(reader.width());
  map.depth = static_cast<int>(reader.depth());
  map.samples = std::move(samples);
  return map;
}

}  // namespace

bool is_png(std::span<const std::byte> bytes) {
  constexpr std::string_view kSignature{"\x89PNG\r\n\x1a\n"};
  return bytes.size() >= kSignature.size() &&
         std::memcmp(bytes.data(), kSignature.data(), kSignature.size()) == 0;
}

DecodeResult decode_png(std::span<const std::byte> bytes) {
  Reader reader{bytes};
  if (!reader.read_header()) return refused("is not a whole PNG: " + reader.complaint());
  const bool is_byte = reader.bit_depth() == 8;
  if (!reader.grey() || !(is_byte || reader.bit_depth() == 16)) {
    return refused("is a PNG of " + std::string{reader.colours()} + " with " +
                   std::to_string(reader.bit_depth()) +
                   " bits a channel; grey alone of 8 or 16 bits is needed");
  }
  if (auto wrong = wrong_size(reader.width(), reader.depth())) return refused(*std::move(wrong));
  constexpr std::uint64_t kMaxCompression = 1032;  // of Deflate; checked before memory is allocated
  const std::uint64_t sample_bytes = is_byte ? 1 : 2;
  if (reader.width() * reader.depth() * sample_bytes / kMaxCompression > bytes.size()) {
    return refused("is not a whole PNG: " + std::to_string(bytes.size()) + " bytes cannot hold " +
                   std::to_string(reader.width()) + " x " + std::to_string(reader.depth()) + " samples");
  }
  return is_byte ? map_of<std::uint8_t>(reader) : map_of<std::uint16_t>(reader);
}

}  // namespace talus::world_files
