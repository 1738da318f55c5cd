// Volumes voxel by voxel, as FORMAT.md has them: what the kernels of every instruction set must equal.
#pragma once

#include "volume_kernels.h"

namespace talus::codec {

void analyse_volume_scalar(const DenseVoxels& voxels, VolumeEvents& events);
void write_volume_scalar(const VolumeEvents& events, std::size_t first, std::size_t count,
                         const std::uint32_t* intervals, RansSink& sink);
VolumeFault read_volume_scalar(VolumeSource& source, const VolumeCode& code, PaddedVoxels& padded);

/// The context from which a batch's contexts count.
[[nodiscard]] constexpr std::size_t first_context_of(std::size_t batch) {
  return batch % 2 == 0 ? 0 : kOddContexts;
}

}  // namespace talus::codec
