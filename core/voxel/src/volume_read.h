// Kernels that read volumes, per instruction set; volume_kernels.h has the complete table.
#pragma once

#include "volume_kernels.h"

namespace talus::codec {

struct VolumeRead {
  VolumeFault (*read)(VolumeSource& source, const VolumeCode& code, PaddedVoxels& padded);
  void (*read_slots)(VolumeSource& source, const SlotTable& slots, std::size_t count, std::uint8_t* kinds);
};
[[nodiscard]] const VolumeRead& volume_read(InstructionSet set);

}  // namespace talus::codec
