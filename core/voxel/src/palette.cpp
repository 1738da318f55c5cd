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

std::uint8_t read_symbol(RangeDecoder& coder, SymbolModels& models, const std::uint8_t* at) {
  const std::uint8_t below = *(at - kBelow);
  const std::uint8_t west = *(at - kWest);
  const std::uint8_t north = *(at - kNorth);
  const std::size_t pattern = below == west    ? (below == north ? 0 : 1)
                              : below == north ? 2
                              : west == north  ? 3
                                               : 4;
  auto& differs = models.differs[pattern];
  if (!coder.read(differs[0])) return below;
  if (west != below && !coder.read(differs[1])) return west;
  if (north != below && north != west && !coder.read(differs[2])) return north;
  std::size_t node = 1;
  for (int bit = 0; bit < 8; ++bit) node = 2 * node + (coder.read(models.index[node]) ? 1U : 0U);
  return static_cast<std::uint8_t>(node - 256);
}

/// False where the bytes ended.
bool read_indices(RangeDecoder& coder, Indices& indices) {
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
        mixed[b] = coder.read(models.is_mixed[context]);
        const std::uint8_t uniform = mixed[b] ? std::uint8_t{0} : read_symbol(coder, models.block, corner);
        for (std::size_t y = 0; y < kBlock; ++y) {
          for (std::size_t z = 0; z < kBlock; ++z) {
            for (std::size_t x = 0; x < kBlock; ++x) {
              std::uint8_t* const at = corner + y * kBelow + z * kNorth + x;
              *at = mixed[b] ? read_symbol(coder, models.voxel, at) : uniform;
            }
          }
        }
      }
      if (coder.starved()) return false;
    }
  }
  return true;
}

}  // namespace

tl::expected<Chunk, DecodeError> decode_palette(std::span<const std::byte> body) {
  const auto materials = take_materials(body, kMaxPalette);
  if (!materials) return tl::unexpected{materials.error()};
  if (std::adjacent_find(materials->begin(), materials->end(), std::greater_equal{}) != materials->end()) {
    return tl::unexpected{DecodeError::bad_materials};
  }
  const auto indices = std::make_unique<Indices>();
  RangeDecoder coder{body};
  if (!read_indices(coder, *indices)) return tl::unexpected{DecodeError::truncated};
  if (const auto fault = coder.fault()) return tl::unexpected{*fault};
  const auto voxels = std::make_shared_for_overwrite<DenseVoxels>();
  for (int y = 0; y < kChunkSize; ++y) {
    for (int z = 0; z < kChunkSize; ++z) {
      const std::uint8_t* const row = indices->data() + place(0, y, z);
      for (int x = 0; x < kChunkSize; ++x) {
        if (row[x] >= materials->size()) return tl::unexpected{DecodeError::bad_number};
        (*voxels)[static_cast<std::size_t>((y * kChunkSize + z) * kChunkSize + x)] = (*materials)[row[x]];
      }
    }
  }
  return Chunk::from_dense(std::shared_ptr<const DenseVoxels>{voxels});
}

}  // namespace talus::codec
