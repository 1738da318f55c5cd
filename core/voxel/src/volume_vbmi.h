// What needs instructions on bytes that some processors with AVX-512 have and others lack (VBMI, VBMI2,
// GFNI).
// volume_batch-inl.h and volume_numbers-inl.h do the same for all.
#pragma once

#include <cstddef>
#include <cstdint>

#include "material_code.h"
#include "volume_rows.h"

namespace talus::codec {

enum class Numbering : std::uint8_t { done, two_alike, too_many };

struct VolumeVbmi {
  /// Of `parts` times 64 bytes, appends those whose bits are set in their part's `bits` and in `columns`;
  /// gives how many. May write 64 bytes past the last.
  std::size_t (*pack)(const std::uint64_t* bits, std::uint64_t columns, const std::uint8_t* bytes,
                      std::size_t parts, std::uint8_t* out);
  /// Appends contexts and symbols of a wave's coded voxels, of as many pairs of rows: those in even columns
  /// first. May write 64 bytes past the last.
  CodedHalves (*pack_wave)(const WaveBits& bits, std::size_t pairs, std::uint8_t* contexts,
                           std::uint8_t* symbols);
  /// Writes the low bytes of the ids to `rows` and adds their materials to `materials`. two_alike: all
  /// were added, but two materials have one number. too_many: there are more than
  /// MaterialCode::kMaxMaterials, and both outputs are incomplete.
  Numbering (*number)(const std::uint16_t* ids, VoxelRows& rows, MaterialCode& materials);
  /// Start and size of the interval of each of `count` symbols, at most kMaxBatch. `ends`: those of
  /// VolumeSymbols from the batch's first context on, 256 of an odd batch and 128 of an even one. Reads and
  /// writes whole vectors of 64 bytes, with 0 after the last.
  void (*intervals)(const std::uint8_t* ends, bool odd, const std::uint8_t* contexts,
                    const std::uint8_t* symbols, std::size_t count, std::uint8_t* starts,
                    std::uint8_t* sizes);
};

/// Null where this processor has no such instructions.
[[nodiscard]] const VolumeVbmi* volume_vbmi();

}  // namespace talus::codec
