// A chunk's voxels as bytes, wave by wave, as encoders need them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "volume_model.h"

namespace talus::codec {

/// A byte for each voxel. The rows of a wave lie side by side, by y, and with room around them: encoders put
/// there what takes the place of rows that are not there, and may read what nobody wrote.
class VoxelRows {
 public:
  static constexpr std::size_t kRow = kChunkSize;
  static constexpr std::size_t kWave = (kChunkSize + 4) * kRow;  // from a wave to the next

  /// Where the row y = 0 of a wave lies, or would; waves from -3 on.
  [[nodiscard]] std::uint8_t* of(int wave) {
    return bytes_.data() + static_cast<std::size_t>(wave + kBefore) * kWave + 2 * kRow;
  }
  /// Where the row lies whose place in dense order is `index`: 0 to 1023.
  [[nodiscard]] std::uint8_t* row(std::size_t index) {
    const std::size_t y = index / kChunkSize;
    const std::size_t z = index % kChunkSize;
    return bytes_.data() + (z + 2 * y + kBefore) * kWave + (y + 2) * kRow;
  }

 private:
  static constexpr int kBefore = 3;
  alignas(64) std::array<std::uint8_t, (kWaves + kBefore + 1) * kWave> bytes_;
};

/// Of the rows of a wave a word each, from its first: bit x is the voxel at x. Sixteen rows at most.
using RowWords = std::array<std::uint32_t, 16>;

/// What is coded of a wave.
struct WaveBits {
  alignas(64) RowWords coded;
  alignas(64) std::array<RowWords, 8> context;  // bits of the context within its half, the lowest first
  alignas(64) std::array<RowWords, 2> symbol;
};

/// How many voxels of a wave are coded, in even columns and in odd ones.
struct CodedHalves {
  std::size_t even;
  std::size_t odd;
};

}  // namespace talus::codec
