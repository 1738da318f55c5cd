#include "header.h"

#include <algorithm>
#include <array>

#include <talus/voxel/chunk.h>

namespace talus::codec {

std::byte* put_number(std::uint16_t number, std::byte* out) {
  unsigned rest = number;
  for (; rest >= 0x80; rest >>= 7) *out++ = static_cast<std::byte>(rest | 0x80U);
  *out++ = static_cast<std::byte>(rest);
  return out;
}

void put_number(std::uint16_t number, std::vector<std::byte>& out) {
  std::array<std::byte, kMaxBytesOfNumber> bytes;
  out.insert(out.end(), bytes.data(), put_number(number, bytes.data()));
}

tl::expected<std::uint16_t, DecodeError> take_number(std::span<const std::byte>& bytes) {
  std::uint32_t number = 0;
  for (int shift = 0; shift <= 14; shift += 7) {
    if (bytes.empty()) return tl::unexpected{DecodeError::truncated};
    const auto byte = std::to_integer<std::uint32_t>(bytes.front());
    bytes = bytes.subspan(1);
    number |= (byte & 0x7FU) << shift;
    if (byte >= 0x80) continue;
    const bool minimal = byte != 0 || shift == 0;
    if (!minimal || number > 0xFFFF) break;
    return static_cast<std::uint16_t>(number);
  }
  return tl::unexpected{DecodeError::bad_number};
}

void put_materials(std::span<const MaterialId> materials, std::vector<std::byte>& out) {
  put_number(static_cast<std::uint16_t>(materials.size()), out);
  for (const MaterialId material : materials) put_number(to_integer(material), out);
}

tl::expected<std::vector<MaterialId>, DecodeError> take_materials(std::span<const std::byte>& bytes,
                                                                  std::size_t max_count) {
  const auto count = take_number(bytes);
  if (!count) return tl::unexpected{count.error()};
  if (*count == 0 || *count > max_count) return tl::unexpected{DecodeError::bad_materials};
  std::vector<MaterialId> materials;
  materials.reserve(*count);
  while (materials.size() < *count) {
    const auto id = take_number(bytes);
    if (!id) return tl::unexpected{id.error()};
    materials.push_back(MaterialId{*id});
  }
  return materials;
}

tl::expected<std::vector<MaterialId>, DecodeError> take_layer_materials(std::span<const std::byte>& bytes) {
  auto materials = take_materials(bytes, Layers::kMaxMaterials);
  if (materials && std::adjacent_find(materials->begin(), materials->end()) != materials->end()) {
    return tl::unexpected{DecodeError::bad_materials};
  }
  return materials;
}

}  // namespace talus::codec
