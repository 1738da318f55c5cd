// A chunk's voxels as bytes, wave by wave, for encoders.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "volume_model.h"

namespace talus::codec {

/// One byte per voxel. The rows of a wave are adjacent, by y, with room around them: encoders put
/// replacements of missing rows there, and may read uninitialised bytes.
class VoxelRows {
 public:
  static constexpr std::size_t kRow = kChunkSize;
  static constexpr std::size_t kWave = (kChunkSize + 4) * kRow;  // distance between waves

  /// Address of row y = 0 of a wave, even if it has no such row; waves from -3.
  [[nodiscard]] std::uint8_t* of(int wave) {
    return bytes_.data() + static_cast<std::size_t>(wave + kBefore) * kWave + 2 * kRow;
  }
  /// Address of the row with this index in dense order, 0 to 1023.
  [[nodiscard]] std::uint8_t* row(std::size_t index) {
    const std::size_t y = index / kChunkSize;
    const std::size_t z = index % kChunkSize;
    return bytes_.data() + (z + 2 * y + kBefore) * kWave + (y + 2) * kRow;
  }

 private:
  static constexpr int kBefore = 3;
  alignas(64) std::array<std::uint8_t, (kWaves + kBefore + 1) * kWave> bytes_;
};

/// One word per row of a wave, from its first: bit x is the voxel at x. At most sixteen rows.
using RowWords = std::array<std::uint32_t, 16>;

/// Coded bits of a wave.
struct WaveBits {
  alignas(64) RowWords coded;
  alignas(64) std::array<RowWords, 8> context;  // bits of the context within its half, lowest first
  alignas(64) std::array<RowWords, 2> symbol;
};

/// Number of coded voxels of a wave, in even columns and in odd ones.
struct CodedHalves {
  std::size_t even;
  std::size_t odd;
};

}  // namespace talus::codec
