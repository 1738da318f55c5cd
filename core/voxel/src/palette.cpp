#include "palette.h"

#include <algorithm>
#include <array>
#include <functional>
#include <memory>

#include "header.h"
#include "range_coder.h"

namespace talus::codec {
namespace {

// A border of one voxel on the low sides lets the first voxels have neighbours too.
constexpr std::size_t kEdge = kChunkSize + 1;
constexpr std::size_t kWest = 1;
constexpr std::size_t kNorth = kEdge;
constexpr std::size_t kBelow = kEdge * kEdge;
using Indices = std::array<std::uint8_t, kEdge * kEdge * kEdge>;

constexpr std::size_t place(int x, int y, int z) {
  return (static_cast<std::size_t>(y + 1) * kEdge + static_cast<std::size_t>(z + 1)) * kEdge +
         static_cast<std::size_t>(x + 1);
}

constexpr int kBlock = 4;
constexpr int kBlocks = kChunkSize / kBlock;

struct SymbolModels {
  std::array<std::array<BitModel, 3>, 5> differs;  // pattern of the neighbours; from below, west, north
  std::array<BitModel, 256> index;
};

struct PaletteModels {
  SymbolModels voxel;
  SymbolModels block;
  std::array<BitModel, 8> is_mixed;
};

template <class Coder>
std::uint8_t code_symbol(Coder& coder, SymbolModels& models, const std::uint8_t* at, std::uint8_t value) {
  const std::uint8_t below = *(at - kBelow);
  const std::uint8_t west = *(at - kWest);
  const std::uint8_t north = *(at - kNorth);
  const std::size_t pattern = below == west    ? (below == north ? 0 : 1)
                              : below == north ? 2
                              : west == north  ? 3
                                               : 4;
  auto& differs = models.differs[pattern];
  if (!coder.code(differs[0], value != below)) return below;
  if (west != below && !coder.code(differs[1], value != west)) return west;
  if (north != below && north != west && !coder.code(differs[2], value != north)) return north;
  std::size_t node = 1;
  for (int bit = 7; bit >= 0; --bit) {
    node = 2 * node + (coder.code(models.index[node], ((value >> bit) & 1) != 0) ? 1U : 0U);
  }
  return static_cast<std::uint8_t>(node - 256);
}

bool uniform_block(const std::uint8_t* corner) {
  for (std::size_t y = 0; y < kBlock; ++y) {
    for (std::size_t z = 0; z < kBlock; ++z) {
      for (std::size_t x = 0; x < kBlock; ++x) {
        if (corner[y * kBelow + z * kNorth + x] != *corner) return false;
      }
    }
  }
  return true;
}

/// False where the encoder passed its limit or the decoder ran out of bytes.
template <class Coder, class Stop>
bool code_indices(Coder& coder, Indices& indices, const Stop& stop) {
  PaletteModels models;
  std::array<bool, kBlocks * kBlocks * kBlocks> mixed{};
  for (int by = 0; by < kBlocks; ++by) {
    for (int bz = 0; bz < kBlocks; ++bz) {
      for (int bx = 0; bx < kBlocks; ++bx) {
        const auto b = static_cast<std::size_t>((by * kBlocks + bz) * kBlocks + bx);
        std::uint8_t* const corner = indices.data() + place(bx * kBlock, by * kBlock, bz * kBlock);
        const std::size_t context = (bx > 0 && mixed[b - 1] ? 1U : 0U) +
                                    (bz > 0 && mixed[b - kBlocks] ? 2U : 0U) +
                                    (by > 0 && mixed[b - kBlocks * kBlocks] ? 4U : 0U);
        if constexpr (!Coder::kDecodes) mixed[b] = !uniform_block(corner);
        mixed[b] = coder.code(models.is_mixed[context], mixed[b]);
        if (!mixed[b]) {
          const std::uint8_t value = code_symbol(coder, models.block, corner, *corner);
          if constexpr (Coder::kDecodes) {
            for (std::size_t y = 0; y < kBlock; ++y) {
              for (std::size_t z = 0; z < kBlock; ++z) {
                std::fill_n(corner + y * kBelow + z * kNorth, kBlock, value);
              }
            }
          }
          continue;
        }
        for (std::size_t y = 0; y < kBlock; ++y) {
          for (std::size_t z = 0; z < kBlock; ++z) {
            for (std::size_t x = 0; x < kBlock; ++x) {
              std::uint8_t* const at = corner + y * kBelow + z * kNorth + x;
              *at = code_symbol(coder, models.voxel, at, *at);
            }
          }
        }
      }
      if (stop()) return false;
    }
  }
  return true;
}

}  // namespace

bool encode_palette(std::span<const MaterialId, kChunkVolume> voxels, std::size_t limit,
                    std::vector<std::byte>& out) {
  // The place of each material in the palette; only those of materials that occur are ever written.
  const auto places = std::make_unique_for_overwrite<std::array<std::uint8_t, 0x10000>>();
  std::vector<MaterialId> materials;
  std::vector<bool> seen(0x10000);
  MaterialId last = voxels.front();
  seen[to_integer(last)] = true;
  materials.push_back(last);
  for (const MaterialId material : voxels) {
    if (material == last) continue;
    last = material;
    if (seen[to_integer(material)]) continue;
    if (materials.size() == kMaxPalette) return false;
    seen[to_integer(material)] = true;
    materials.push_back(material);
  }
  std::sort(materials.begin(), materials.end());
  for (std::size_t i = 0; i < materials.size(); ++i) {
    (*places)[to_integer(materials[i])] = static_cast<std::uint8_t>(i);
  }
  const auto indices = std::make_unique<Indices>();
  for (int y = 0; y < kChunkSize; ++y) {
    for (int z = 0; z < kChunkSize; ++z) {
      const MaterialId* const row = voxels.data() + (y * kChunkSize + z) * kChunkSize;
      std::uint8_t* const to = indices->data() + place(0, y, z);
      for (std::size_t x = 0; x < kChunkSize; ++x) to[x] = (*places)[to_integer(row[x])];
    }
  }
  const std::size_t start = out.size();
  put_materials(materials, out);
  Encoder coder{out};
  const auto over = [&] { return out.size() - start >= limit; };
  const bool within = code_indices(coder, *indices, over);
  coder.finish();
  if (within && !over()) return true;
  out.resize(start);
  return false;
}

tl::expected<Chunk, DecodeError> decode_palette(std::span<const std::byte> body) {
  const auto materials = take_materials(body, kMaxPalette);
  if (!materials) return tl::unexpected{materials.error()};
  if (std::adjacent_find(materials->begin(), materials->end(), std::greater_equal{}) != materials->end()) {
    return tl::unexpected{DecodeError::bad_materials};
  }
  const auto indices = std::make_unique<Indices>();
  Decoder coder{body};
  if (!code_indices(coder, *indices, [&] { return coder.starved(); })) {
    return tl::unexpected{DecodeError::truncated};
  }
  if (const auto fault = coder.fault()) return tl::unexpected{*fault};
  const auto voxels = std::make_unique_for_overwrite<DenseVoxels>();
  for (int y = 0; y < kChunkSize; ++y) {
    for (int z = 0; z < kChunkSize; ++z) {
      const std::uint8_t* const row = indices->data() + place(0, y, z);
      for (int x = 0; x < kChunkSize; ++x) {
        if (row[x] >= materials->size()) return tl::unexpected{DecodeError::bad_number};
        (*voxels)[static_cast<std::size_t>((y * kChunkSize + z) * kChunkSize + x)] = (*materials)[row[x]];
      }
    }
  }
  return Chunk::from_dense(*voxels);
}

}  // namespace talus::codec
