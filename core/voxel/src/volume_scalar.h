// Volumes voxel by voxel, as FORMAT.md has them: what the kernels of every instruction set must equal.
#pragma once

#include "volume_kernels.h"

namespace talus::codec {

bool analyse_volume_scalar(const DenseVoxels& voxels, VolumeEvents& events);
void write_volume_scalar(const VolumeEvents& events, std::size_t first, std::size_t count,
                         const std::uint32_t* intervals, RansSink& sink);
void write_intervals_scalar(const std::uint32_t* intervals, std::size_t count, RansSink& sink);
void read_slots_scalar(VolumeSource& source, const SlotTable& slots, std::size_t count, std::uint8_t* kinds);
VolumeFault read_volume_scalar(VolumeSource& source, const VolumeCode& code, PaddedVoxels& padded);

inline constexpr VolumeKernels kScalarVolume{analyse_volume_scalar, write_volume_scalar,
                                             write_intervals_scalar, read_slots_scalar, read_volume_scalar};

/// The context from which a batch's contexts count.
[[nodiscard]] constexpr std::size_t first_context_of(std::size_t batch) {
  return batch % 2 == 0 ? 0 : kOddContexts;
}

}  // namespace talus::codec
