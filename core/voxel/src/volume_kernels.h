// Conversion of volumes to symbols and back, a vector of voxels at a time, one implementation per instruction
// set: FORMAT.md, "Volume".
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <talus/vectors/instruction_set.h>
#include <talus/voxel/chunk.h>

#include "rans.h"
#include "volume_code.h"
#include "volume_model.h"

namespace talus::codec {

/// A batch is a wave's even columns, or its odd ones: at most sixteen rows of sixteen columns.
inline constexpr std::size_t kBatches = 2 * kWaves;
inline constexpr std::size_t kMaxBatch = 16 * kLanes;

/// A steady voxel that differs from its first candidate. If the voxel to its south were steady too, it would
/// equal the one below; so each exception has its own coded voxel, except in the last rows.
struct VolumeException {
  std::uint16_t gap;    // number of steady voxels as predicted since the last exception
  std::uint16_t batch;  // the batch that contains it
  MaterialId material;
};
inline constexpr std::size_t kMaxExceptions = kChunkVolume / 2 + kChunkArea / 2;

/// Encoder output for a chunk, in coding order. Vectors may write some entries past `coded`.
struct VolumeEvents {
  std::array<std::uint8_t, kChunkVolume + 64> context;  // by coded voxel, relative to its half
  std::array<std::uint8_t, kChunkVolume + 64> symbol;
  std::array<std::uint16_t, kBatches> batch;          // number of coded voxels per batch
  std::array<std::uint16_t, kBatches> batch_escapes;  // number of these with symbol kEscape
  std::array<VolumeException, kMaxExceptions> exception;
  std::array<MaterialId, kChunkVolume> escape;  // materials of symbols kEscape
  std::size_t coded = 0;
  std::size_t changes = 0;  // voxels that differ from the voxel to their west in the same row
  std::size_t surprises =
      0;  // coded voxels of the first kProbeWaves waves that differ from their first candidate
  std::size_t exceptions = 0;
  std::size_t escapes = 0;
};

/// Intervals of the symbols by one of the format's tables.
struct VolumeSymbols {
  std::array<std::uint32_t, 4 * kVolumeContexts> interval;  // by context and symbol: start + 65536 * size
  std::array<std::uint8_t, kVolumeContexts> ends;  // by context: index of its intervals in kVolumeEnds
};

/// Batches `begin` to `end` - 1, with the first and the number of their coded voxels.
struct EventBatches {
  std::size_t begin;
  std::size_t end;
  std::size_t first_coded;
  std::size_t coded;
};

/// Analysis stops early, with undefined events, if the first kProbeWaves waves, a quarter of the voxels, have
/// more than kMaxSurprises surprises, or more than kManySurprises and twice as many as changes: this is
/// noise, for which runs are shorter.
inline constexpr std::size_t kProbeWaves = 32;
inline constexpr std::size_t kMaxSurprises = 3072;
inline constexpr std::size_t kManySurprises = 1024;
[[nodiscard]] inline bool is_noise(std::size_t batches, const VolumeEvents& events) {
  return batches == 2 * kProbeWaves &&
         (events.surprises > kMaxSurprises ||
          (events.surprises > kManySurprises && events.surprises > 2 * events.changes));
}

enum class VolumeFault : std::uint8_t { none, truncated, bad_number };

/// Destination of a decoder; kVolumeMargin voxels after the chunk may be overwritten too.
inline constexpr std::size_t kVolumeMargin = 32;
struct PaddedVoxels {
  DenseVoxels voxels;
  std::array<MaterialId, kVolumeMargin> after{};
};

struct VolumeKernels {
  /// Computes the events of `voxels`; returns false for noise.
  bool (*analyse)(const DenseVoxels& voxels, VolumeEvents& events);
  /// Writes the symbols of whole batches, last one first.
  void (*write)(const VolumeEvents& events, const EventBatches& batches, const VolumeSymbols& symbols,
                RansSink& sink);
  /// Writes `count` symbols, last one first; the first is in lane 0. Intervals: start + 65536 * size.
  void (*write_intervals)(const std::uint32_t* intervals, std::size_t count, RansSink& sink);
  /// Reads `count` kinds of symbols, at most kMaxBatch.
  void (*read_slots)(VolumeSource& source, const SlotTable& slots, std::size_t count, std::uint8_t* kinds);
  /// After a fault, the voxels are undefined.
  VolumeFault (*read)(VolumeSource& source, const VolumeCode& code, PaddedVoxels& padded);
};

[[nodiscard]] VolumeKernels volume_kernels(InstructionSet set);

/// The kernels of instruction_set().
[[nodiscard]] const VolumeKernels& volume_kernels();

}  // namespace talus::codec
