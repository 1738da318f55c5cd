#include "plane_kernels.h"

namespace talus::codec {

PlaneKernels plane_kernels(InstructionSet set) {
  const PlaneEncode& encode = plane_encode(set);
  return {plane_decode(set), encode.model, encode.encode};
}

const PlaneKernels& plane_kernels() {
  static const PlaneKernels kKernels = plane_kernels(instruction_set());
  return kKernels;
}

}  // namespace talus::codec
