// The reading kernel of volumes of an instruction set; volume_kernels.h has the whole table.
#pragma once

#include "volume_kernels.h"

namespace talus::codec {

using VolumeRead = VolumeFault (*)(VolumeSource& source, const VolumeCode& code, PaddedVoxels& padded);
[[nodiscard]] VolumeRead volume_read(InstructionSet set);

}  // namespace talus::codec
