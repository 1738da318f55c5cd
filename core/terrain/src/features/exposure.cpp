#include "features/exposure.h"

#include <algorithm>
#include <cassert>
#include <span>

#include <talus/terrain/boundary_row.h>

namespace talus::terrain {
namespace {

constexpr int kWide = kChunkSize + 2;  // columns and rows of a chunk with one more on either side
constexpr std::uint64_t kAllRows = (std::uint64_t{1} << kWide) - 1;

// Bit r is set for row lowest + r of a column that is not ground.
class OpenRows {
 public:
  explicit OpenRows(const ChunkSite& site)
      : stacks_{site.stacks()}, lowest_{chunk_origin(site.key().coord).y - 1} {}

  [[nodiscard]] std::uint64_t at(int x, int z) const {
    std::uint64_t open = kAllRows & ~under(stacks_.tops.back().at(x, z));
    if (!stacks_.caves.none()) {
      open |= under(stacks_.caves.roof.at(x, z)) & ~under(stacks_.caves.floor.at(x, z));
    }
    return open;
  }

 private:
  [[nodiscard]] std::uint64_t under(std::int32_t boundary_fx) const {
    return (std::uint64_t{1} << std::clamp<std::int64_t>(boundary_row(boundary_fx) - lowest_, 0, kWide)) - 1;
  }

  const Stacks& stacks_;
  std::int64_t lowest_;
};

}  // namespace

std::optional<ExposedRows> exposed_rows(const ChunkSite& site) {
  assert(site.key().lod == Lod{} && site.x() >= 1 && site.z() >= 1);
  assert(site.x() + kChunkSize < site.stacks().region.width &&
         site.z() + kChunkSize < site.stacks().region.depth);
  const OpenRows rows{site};
  std::array<std::uint64_t, std::size_t{kWide} * kWide> open;
  std::uint64_t any = 0;
  for (int z = 0; z < kWide; ++z) {
    for (int x = 0; x < kWide; ++x) {
      const std::uint64_t column = rows.at(site.x() - 1 + x, site.z() - 1 + z);
      open[static_cast<std::size_t>(z * kWide + x)] = column;
      any |= column;
    }
  }
  if (any == 0) return std::nullopt;
  ExposedRows exposed;
  for (int z = 0; z < kChunkSize; ++z) {
    for (int x = 0; x < kChunkSize; ++x) {
      const std::uint64_t* const here = open.data() + (z + 1) * kWide + x + 1;
      const std::uint64_t beside = here[-1] | here[1] | here[-kWide] | here[kWide];
      exposed[column_index(x, z)] = static_cast<std::uint32_t>((beside >> 1U) | *here | (*here >> 2U));
    }
  }
  return exposed;
}

}  // namespace talus::terrain
