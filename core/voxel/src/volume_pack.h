// The bytes of a batch's coded voxels side by side, by an instruction that some processors with AVX-512 have
// and others lack (VBMI2); volume_batch-inl.h does it for all.
#pragma once

#include <cstddef>
#include <cstdint>

namespace talus::codec {

/// Of `parts` times 64 bytes, appends those whose bits are set; gives how many. May write 64 bytes past the
/// last.
using VolumePack = std::size_t (*)(const std::uint64_t* coded, const std::uint8_t* bytes, std::size_t parts,
                                   std::uint8_t* out);

/// Null where this processor has no such instruction.
[[nodiscard]] VolumePack volume_pack();

}  // namespace talus::codec
