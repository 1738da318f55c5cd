// NumPy array files, versions 1 to 3:
// https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html
#include <bit>
#include <cstring>
#include <string_view>
#include <utility>
#include <vector>

#include "decoders.h"

namespace talus::world_files {
namespace {

static_assert(std::endian::native == std::endian::little, "samples are taken as they lie in the file");

constexpr std::string_view kMagic{"\x93NUMPY"};
constexpr std::size_t kMaxHeaderBytes = 4096;

// The header is a Python dictionary with three keys. Returns the text after `"'key': "`, if present.
std::optional<std::string_view> value_of(std::string_view header, std::string_view key) {
  const std::string quoted = "'" + std::string{key} + "':";
  const std::size_t at = header.find(quoted);
  if (at == std::string_view::npos) return std::nullopt;
  header.remove_prefix(at + quoted.size());
  header.remove_prefix(std::min(header.find_first_not_of(' '), header.size()));
  return header;
}

std::optional<std::uint64_t> take_number(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  std::uint64_t number = 0;
  std::size_t digits = 0;
  while (digits < text.size() && text[digits] >= '0' && text[digits] <= '9') {
    if (digits == 10) return std::nullopt;
    number = number * 10 + static_cast<std::uint64_t>(text[digits] - '0');
    ++digits;
  }
  text.remove_prefix(digits);
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  return digits == 0 ? std::nullopt : std::optional{number};
}

bool take(std::string_view& text, char c) {
  if (text.empty() || text.front() != c) return false;
  text.remove_prefix(1);
  return true;
}

struct Shape {
  std::uint64_t depth = 0;
  std::uint64_t width = 0;
};

std::optional<Shape> shape_of(std::string_view text) {
  if (!take(text, '(')) return std::nullopt;
  const auto depth = take_number(text);
  if (!depth || !take(text, ',')) return std::nullopt;
  const auto width = take_number(text);
  if (!width) return std::nullopt;
  take(text, ',');
  if (!take(text, ')')) return std::nullopt;
  return Shape{*depth, *width};
}

template <class Sample>
DecodeResult map_of(Shape shape, std::span<const std::byte> data) {
  const std::size_t wanted = shape.width * shape.depth * sizeof(Sample);
  if (data.size() != wanted) {
    return refused("has " + std::to_string(data.size()) + " bytes of samples; its shape needs " +
                   std::to_string(wanted));
  }
  std::vector<Sample> samples(shape.width * shape.depth);
  std::memcpy(samples.data(), data.data(), data.size());
  terrain::HeightMap map;
  map.width = static_cast<int>(shape.width);
  map.depth = static_cast<int>(shape.depth);
  map.samples = std::move(samples);
  return map;
}

}  // namespace

bool is_npy(std::span<const std::byte> bytes) {
  return bytes.size() >= kMagic.size() && std::memcmp(bytes.data(), kMagic.data(), kMagic.size()) == 0;
}

DecodeResult decode_npy(std::span<const std::byte> bytes) {
  const auto byte = [&](std::size_t i) { return std::to_integer<std::size_t>(bytes[i]); };
  if (bytes.size() < 12) return refused("is an .npy that ends in its header");
  const std::size_t version = byte(6);
  if (version < 1 || version > 3) {
    return refused("is an .npy of version " + std::to_string(version) + "; 1 to 3 are known");
  }
  const std::size_t start = version == 1 ? 10 : 12;
  std::size_t length = byte(8) | byte(9) << 8;
  if (version > 1) length |= byte(10) << 16 | byte(11) << 24;
  if (length > kMaxHeaderBytes || start + length > bytes.size()) {
    return refused("is an .npy that ends in its header");
  }
  const std::string_view header{reinterpret_cast<const char*>(bytes.data()) + start, length};
  const auto type = value_of(header, "descr");
  const auto order = value_of(header, "fortran_order");
  const auto axes = value_of(header, "shape");
  if (!type || !order || !axes) return refused("is an .npy without descr, fortran_order and shape");
  if (!order->starts_with("False")) return refused("is an .npy in Fortran's order; C's is needed");
  const auto shape = shape_of(*axes);
  if (!shape) return refused("is an .npy without exactly two axes, rows and columns");
  if (auto wrong = wrong_size(shape->width, shape->depth)) return refused(*std::move(wrong));
  const auto data = bytes.subspan(start + length);
  if (type->starts_with("'<u2'")) return map_of<std::uint16_t>(*shape, data);
  if (type->starts_with("'<i4'")) return map_of<std::int32_t>(*shape, data);
  if (type->starts_with("'<f4'")) return map_of<float>(*shape, data);
  return refused("is an .npy of another type than '<u2', '<i4' and '<f4'; one of them is needed");
}

}  // namespace talus::world_files
