#include "npy.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace talus::cli {
namespace {

// Format version 1.0: magic, version, u16 length, a dictionary padded so that the data begin at 64 bytes.
std::string header(std::string_view type) {
  constexpr std::size_t kAlignment = 64;
  constexpr std::size_t kBeforeDictionary = 10;
  std::string dictionary =
      "{'descr': '" + std::string{type} + "', 'fortran_order': False, 'shape': (32, 32, 32), }";
  while ((kBeforeDictionary + dictionary.size() + 1) % kAlignment != 0) dictionary += ' ';
  dictionary += '\n';
  std::string text{"\x93NUMPY\x01\x00", 8};
  text += static_cast<char>(dictionary.size() & 0xFFU);
  text += static_cast<char>(dictionary.size() >> 8U);
  return text + dictionary;
}

}  // namespace

std::vector<std::byte> npy_of(const Chunk& chunk, const std::vector<client::Material>& materials) {
  const bool narrow = std::all_of(materials.begin(), materials.end(),
                                  [](const auto& material) { return to_integer(material.id) < 256; });
  const std::string head = header(narrow ? "|u1" : "<u2");
  const auto* begin = reinterpret_cast<const std::byte*>(head.data());
  std::vector<std::byte> bytes{begin, begin + head.size()};
  std::vector<MaterialId> voxels(kChunkVolume);
  chunk.copy_to(std::span<MaterialId, kChunkVolume>{voxels});
  bytes.reserve(bytes.size() + voxels.size() * (narrow ? 1 : 2));
  for (const MaterialId voxel : voxels) {
    bytes.push_back(static_cast<std::byte>(to_integer(voxel) & 0xFFU));
    if (!narrow) bytes.push_back(static_cast<std::byte>(to_integer(voxel) >> 8U));
  }
  return bytes;
}

}  // namespace talus::cli
