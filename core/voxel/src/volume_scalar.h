// Scalar coding of volumes, as in FORMAT.md: the reference for the kernels of every instruction set.
#pragma once

#include <functional>

#include "volume_kernels.h"

namespace talus::codec {

bool analyse_volume_scalar(const DenseVoxels& voxels, VolumeEvents& events);
void write_volume_scalar(const VolumeEvents& events, const EventBatches& batches,
                         const VolumeSymbols& symbols, RansSink& sink);
void write_intervals_scalar(const std::uint32_t* intervals, std::size_t count, RansSink& sink);
void read_slots_scalar(VolumeSource& source, const SlotTable& slots, std::size_t count, std::uint8_t* kinds);
VolumeFault read_volume_scalar(VolumeSource& source, const VolumeCode& code, PaddedVoxels& padded);

/// A decoded symbol, for explain().
struct VolumeSymbol {
  std::size_t voxel;
  std::size_t context;
  std::uint32_t ends;  // the context's intervals, as in VolumeIntervals
  std::size_t symbol;
  std::size_t lane;
  std::uint32_t state;     // the lane's, before the symbol
  std::size_t bytes_left;  // left in the payload, before the symbol
};
using SeeSymbol = std::function<void(const RansSource&, const VolumeSymbol&)>;
VolumeFault read_volume_scalar(VolumeSource& source, const VolumeCode& code, PaddedVoxels& padded,
                               const SeeSymbol& see);

inline constexpr VolumeKernels kScalarVolume{analyse_volume_scalar, write_volume_scalar,
                                             write_intervals_scalar, read_slots_scalar, read_volume_scalar};

/// Offset of a batch's contexts.
[[nodiscard]] constexpr std::size_t first_context_of(std::size_t batch) {
  return batch % 2 == 0 ? 0 : kOddContexts;
}

}  // namespace talus::codec
