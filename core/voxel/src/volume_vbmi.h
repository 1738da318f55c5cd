// Kernels for byte instructions that only some processors with AVX-512 have (VBMI, VBMI2, GFNI).
// volume_batch-inl.h and volume_numbers-inl.h do the same for all processors.
#pragma once

#include <cstddef>
#include <cstdint>

#include "material_code.h"
#include "volume_rows.h"

namespace talus::codec {

enum class Numbering : std::uint8_t { done, two_alike, too_many };

struct VolumeVbmi {
  /// Appends the bytes, of `parts` times 64, whose bits are set in both their part's `bits` and `columns`;
  /// returns their number. May write 64 bytes past the last.
  std::size_t (*pack)(const std::uint64_t* bits, std::uint64_t columns, const std::uint8_t* bytes,
                      std::size_t parts, std::uint8_t* out);
  /// Appends contexts and symbols of a wave's coded voxels in `pairs` pairs of rows, even columns first. May
  /// write 64 bytes past the last.
  CodedHalves (*pack_wave)(const WaveBits& bits, std::size_t pairs, std::uint8_t* contexts,
                           std::uint8_t* symbols);
  /// Writes the low bytes of the ids to `rows` and adds their materials to `materials`. two_alike: all were
  /// added, but two materials share a number. too_many: there are more than MaterialCode::kMaxMaterials, and
  /// both outputs are incomplete.
  Numbering (*number)(const std::uint16_t* ids, VoxelRows& rows, MaterialCode& materials);
  /// Start and size of the interval of each of `count` symbols, at most kMaxBatch. `ends`:
  /// VolumeSymbols::ends from the batch's first context on, 256 entries for an odd batch, 128 for an even
  /// one. Reads and writes whole vectors of 64 bytes, with 0 after the last symbol.
  void (*intervals)(const std::uint8_t* ends, bool odd, const std::uint8_t* contexts,
                    const std::uint8_t* symbols, std::size_t count, std::uint8_t* starts,
                    std::uint8_t* sizes);
};

/// Null if this processor lacks these instructions.
[[nodiscard]] const VolumeVbmi* volume_vbmi();

}  // namespace talus::codec
