// Kernels that write volumes, per instruction set; volume_kernels.h has the complete table.
#pragma once

#include "volume_kernels.h"

namespace talus::codec {

struct VolumeWrite {
  bool (*analyse)(const DenseVoxels& voxels, VolumeEvents& events);
  void (*write)(const VolumeEvents& events, const EventBatches& batches, const VolumeSymbols& symbols,
                RansSink& sink);
  void (*write_intervals)(const std::uint32_t* intervals, std::size_t count, RansSink& sink);
};
[[nodiscard]] const VolumeWrite& volume_write(InstructionSet set);

}  // namespace talus::codec
