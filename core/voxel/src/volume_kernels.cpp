#include "volume_kernels.h"

#include "volume_read.h"
#include "volume_write.h"

namespace talus::codec {

VolumeKernels volume_kernels(InstructionSet set) {
  const VolumeWrite& write = volume_write(set);
  const VolumeRead& read = volume_read(set);
  return {write.analyse, write.write, write.write_intervals, read.read_slots, read.read};
}

const VolumeKernels& volume_kernels() {
  static const VolumeKernels kKernels = volume_kernels(instruction_set());
  return kKernels;
}

}  // namespace talus::codec
