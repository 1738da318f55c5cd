// Prediction of voxels of any shape: FORMAT.md, "Volume". Voxel by voxel, as in the document;
// volume_near-inl.h and volume_candidates-inl.h implement the same with vectors.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include <talus/voxel/chunk.h>

namespace talus::codec {

inline constexpr int kVolumeContexts = 128 + 256;  // even columns' contexts, then odd columns'
inline constexpr int kOddContexts = 128;
inline constexpr std::size_t kCandidates = 3;
inline constexpr std::uint8_t kEscape = 3;  // symbol of a voxel that equals no candidate

/// A chunk's rows are coded in waves: wave w holds the rows (y, z) with z + 2 * y = w, by ascending y, so
/// that no row of a wave is a neighbour of an earlier one.
inline constexpr int kWaves = kChunkSize - 1 + 2 * (kChunkSize - 1) + 1;
[[nodiscard]] constexpr int first_row_of(int wave) {
  return std::max(0, (wave - kChunkSize + 2) / 2);
}
[[nodiscard]] constexpr int last_row_of(int wave) {
  return std::min(kChunkSize - 1, wave / 2);
}

/// Rows from which a voxel is predicted. rows_around() replaces missing rows.
struct RowsAround {
  const MaterialId* north;        // (y, z - 1)
  const MaterialId* below;        // (y - 1, z)
  const MaterialId* below_north;  // (y - 1, z - 1)
  const MaterialId* below_south;  // (y - 1, z + 1)
};

/// `row_zero` is north of the first row: 32 times the chunk's first material.
[[nodiscard]] inline RowsAround rows_around(const MaterialId* voxels, const MaterialId* row_zero, int y,
                                            int z) {
  const auto row = [voxels](int at_y, int at_z) { return voxels + (at_y * kChunkSize + at_z) * kChunkSize; };
  if (y == 0) {
    const MaterialId* const north = z == 0 ? row_zero : row(0, z - 1);
    return {north, north, north, north};
  }
  const MaterialId* const below = row(y - 1, z);
  return {z == 0 ? below : row(y, z - 1), below, z == 0 ? below : row(y - 1, z - 1),
          z == kChunkSize - 1 ? below : row(y - 1, z + 1)};
}

/// Prediction of a voxel: distinct candidates, most likely first, and the context that selects the
/// probabilities of its symbol. If `steady`, no symbol is coded: the voxel is the first candidate unless the
/// list of exceptions names it.
struct Prediction {
  std::array<MaterialId, kCandidates> candidate{};
  std::size_t candidates = 0;
  bool steady = false;
  int context = 0;

  void add(MaterialId material) {
    for (std::size_t i = 0; i < candidates; ++i) {
      if (candidate[i] == material) return;
    }
    if (candidates < kCandidates) candidate[candidates++] = material;
  }
};

/// Predicts the voxel at `x`; `row` is its own row, whose even columns are known if x is odd.
[[nodiscard]] inline Prediction predict(const RowsAround& around, const MaterialId* row, int x) {
  constexpr int kLast = kChunkSize - 1;
  const int before = std::max(x - 1, 0);
  const int after = std::min(x + 1, kLast);
  const MaterialId north = around.north[x];
  const MaterialId below = around.below[x];
  const MaterialId below_north = around.below_north[x];
  const MaterialId below_south = around.below_south[x];
  const std::array beside{around.north[after], around.north[before], around.below[after],
                          around.below[before]};
  const bool same = north == below;
  const bool upright = north == below_north;  // no change from below to the north's row
  const bool level = below == below_north;    // no change from north to south in the row below
  const bool level_south = below_south == below;
  const bool east_n = beside[0] == north;
  const bool west_n = beside[1] == north;
  const bool east_b = beside[2] == below;
  const bool west_b = beside[3] == below;
  const MaterialId base = level ? north : below;
  const MaterialId other = level ? below : north;
  const auto bits = [](auto... bit) {
    int value = 0;
    int shift = 0;
    ((value |= int{bit} << shift++), ...);
    return value;
  };
  const int around_bits = bits(upright, level_south, west_n, east_n, west_b, east_b);
  constexpr int kAllAround = 63;

  Prediction prediction;
  if (x % 2 == 0) {
    prediction.steady = same && around_bits == kAllAround;
    prediction.context = same ? around_bits
                              : 64 + bits(level, upright, level_south, below_south == north, west_n && east_n,
                                          west_b && east_b);
  } else {
    const MaterialId west = row[x - 1];
    const MaterialId east = x == kLast ? west : row[x + 1];
    if (west == east) {
      const bool agrees = base == west && other == west;
      prediction.steady = agrees && around_bits == kAllAround;
      prediction.context =
          kOddContexts +
          (agrees ? around_bits : 64 + bits(base == west, other == west, same, upright, level, level_south));
      prediction.add(west);
    } else {
      const bool is_east = base == east || (base != west && other == east);
      const MaterialId first = is_east ? east : west;
      const MaterialId second = is_east ? west : east;
      prediction.context =
          kOddContexts + 128 +
          bits(base == first, other == first, base == second, other == second, upright, level, level_south);
      prediction.add(first);
      prediction.add(second);
    }
  }
  prediction.add(base);
  prediction.add(other);
  for (const MaterialId material : beside) prediction.add(material);
  prediction.add(below_south);
  prediction.add(below_north);
  return prediction;
}

}  // namespace talus::codec
