// NumPy array files.
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string_view>
#include <utility>
#include <vector>

#include <talus/files/npy_header.h>

#include "decoders.h"

namespace talus::world_files {
namespace {

struct Layout {
  std::size_t width = 0;
  std::size_t depth = 0;
  bool by_columns = false;
  bool swapped = false;
};

template <class Stored>
Stored item_at(std::span<const std::byte> data, std::size_t item, bool swapped) {
  std::array<std::byte, sizeof(Stored)> bytes{};
  std::memcpy(bytes.data(), data.data() + item * sizeof(Stored), sizeof(Stored));
  if (swapped) std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<Stored>(bytes);
}

template <class Stored, class Sample = Stored>
DecodeResult map_of(const Layout& layout, std::span<const std::byte> data) {
  const auto [width, depth, by_columns, swapped] = layout;
  const std::size_t wanted = width * depth * sizeof(Stored);
  if (data.size() != wanted) {
    return refused("has " + std::to_string(data.size()) + " bytes of samples; its shape needs " +
                   std::to_string(wanted));
  }
  std::vector<Sample> samples;
  samples.reserve(width * depth);
  for (std::size_t z = 0; z < depth; ++z) {
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t item = by_columns ? x * depth + z : z * width + x;
      samples.push_back(static_cast<Sample>(item_at<Stored>(data, item, swapped)));
    }
  }
  terrain::HeightMap map;
  map.width = static_cast<int>(width);
  map.depth = static_cast<int>(depth);
  map.samples = std::move(samples);
  return map;
}

struct NumberType {
  std::string_view name;  // without its order of bytes
  DecodeResult (*decode)(const Layout&, std::span<const std::byte>);
};

// Samples of types that HeightMap lacks become one that holds them: heights are computed in double.
constexpr std::array kTypes{NumberType{"u1", map_of<std::uint8_t>},
                            NumberType{"u2", map_of<std::uint16_t>},
                            NumberType{"u4", map_of<std::uint32_t, double>},
                            NumberType{"u8", map_of<std::uint64_t, double>},
                            NumberType{"i1", map_of<std::int8_t, std::int32_t>},
                            NumberType{"i2", map_of<std::int16_t, std::int32_t>},
                            NumberType{"i4", map_of<std::int32_t>},
                            NumberType{"i8", map_of<std::int64_t, double>},
                            NumberType{"f4", map_of<float>},
                            NumberType{"f8", map_of<double>}};

bool is_order(char c) {
  return c == '<' || c == '>' || c == '=' || c == '|';
}

std::string shown(std::string_view type) {
  constexpr std::size_t kMaxShown = 16;
  const bool plain = std::all_of(type.begin(), type.end(), [](char c) { return c > ' ' && c <= '~'; });
  return plain && type.size() <= kMaxShown ? "'" + std::string{type} + "'" : "an unknown type";
}

}  // namespace

DecodeResult decode_npy(std::span<const std::byte> bytes) {
  const auto header = files::read_npy_header(bytes);
  if (!header) return refused(header.error());
  const std::string_view type = header->type;
  const bool ordered = !type.empty() && is_order(type.front());
  const NumberType* const end = kTypes.data() + kTypes.size();
  const NumberType* const known = std::find_if(
      kTypes.data(), end, [&](const NumberType& each) { return each.name == type.substr(ordered ? 1 : 0); });
  if (known == end) {
    return refused("is an .npy of " + shown(type) +
                   "; integers of 8 to 64 bits, or floats of 32 or 64, are needed");
  }
  if (header->shape.size() != 2) {
    return refused("is an .npy of " + std::to_string(header->shape.size()) +
                   (header->shape.size() == 1 ? " axis" : " axes") + "; two are needed, rows and columns");
  }
  const std::uint64_t depth = header->shape[0];
  const std::uint64_t width = header->shape[1];
  if (auto wrong = wrong_size(width, depth)) return refused(*std::move(wrong));
  constexpr bool kBigEndian = std::endian::native == std::endian::big;
  const Layout layout{static_cast<std::size_t>(width), static_cast<std::size_t>(depth), header->fortran_order,
                      (type.front() == '>') != kBigEndian};
  return known->decode(layout, bytes.subspan(header->data_at));
}

}  // namespace talus::world_files
