// Volumes to symbols and back, a vector of voxels at a time, once for each instruction set: FORMAT.md,
// "Volume".
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

/// A wave's even columns are a batch, then its odd ones: at most sixteen rows of sixteen columns.
inline constexpr std::size_t kBatches = 2 * kWaves;
inline constexpr std::size_t kMaxBatch = 16 * kLanes;

/// A steady voxel that is not its first candidate. Were the voxel to the south of it steady as well, it would
/// equal the one below; so each exception has a coded voxel of its own, but for those in the last rows.
struct VolumeException {
  std::uint16_t gap;  // how many steady voxels that are as predicted come before it, since the last exception
  std::uint16_t batch;  // in which it is
  MaterialId material;
};
inline constexpr std::size_t kMaxExceptions = kChunkVolume / 2 + kChunkArea / 2;

/// What the encoder writes of a chunk, in coding order. Vectors may write some entries past `coded`.
struct VolumeEvents {
  std::array<std::uint8_t, kChunkVolume + 64> context;  // of each coded voxel, within its half
  std::array<std::uint8_t, kChunkVolume + 64> symbol;
  std::array<std::uint16_t, kBatches> batch;          // coded voxels of each batch
  std::array<std::uint16_t, kBatches> batch_escapes;  // those of them with the symbol kEscape
  std::array<VolumeException, kMaxExceptions> exception;
  std::array<MaterialId, kChunkVolume> escape;  // the materials of the symbols kEscape
  std::size_t coded = 0;
  std::size_t changes = 0;  // voxels that differ from the one to their west, in the same row
  std::size_t surprises =
      0;  // coded voxels of the first kProbeWaves waves that are not their first candidate
  std::size_t exceptions = 0;
  std::size_t escapes = 0;
};

/// What symbols are written by: one of the format's tables.
struct VolumeSymbols {
  std::array<std::uint32_t, 4 * kVolumeContexts> interval;  // by context and symbol: start + 65536 * size
  std::array<std::uint8_t, kVolumeContexts> ends;  // by context: which of kVolumeEnds its intervals have
};

/// Batches `begin` to `end` - 1, and of their coded voxels the first and the count.
struct EventBatches {
  std::size_t begin;
  std::size_t end;
  std::size_t first_coded;
  std::size_t coded;
};

/// Analysis ends early, and the events mean nothing, where the first kProbeWaves waves, a quarter of the
/// voxels, have more than kMaxSurprises, or more than kManySurprises and twice as many as changes: that is
/// noise, which runs take less for.
inline constexpr std::size_t kProbeWaves = 32;
inline constexpr std::size_t kMaxSurprises = 3072;
inline constexpr std::size_t kManySurprises = 1024;
[[nodiscard]] inline bool is_noise(std::size_t batches, const VolumeEvents& events) {
  return batches == 2 * kProbeWaves &&
         (events.surprises > kMaxSurprises ||
          (events.surprises > kManySurprises && events.surprises > 2 * events.changes));
}

enum class VolumeFault : std::uint8_t { none, truncated, bad_number };

/// The voxels that a payload is decoded into: kVolumeMargin voxels after them may be written too.
inline constexpr std::size_t kVolumeMargin = 32;
struct PaddedVoxels {
  DenseVoxels voxels;
  std::array<MaterialId, kVolumeMargin> after{};
};

struct VolumeKernels {
  /// What a decoder has to be told of `voxels`; false where they are noise.
  bool (*analyse)(const DenseVoxels& voxels, VolumeEvents& events);
  /// Writes the symbols of whole batches, the last one first.
  void (*write)(const VolumeEvents& events, const EventBatches& batches, const VolumeSymbols& symbols,
                RansSink& sink);
  /// Writes `count` symbols, the last one first; the lane of the first is 0. Intervals: start + 65536 * size.
  void (*write_intervals)(const std::uint32_t* intervals, std::size_t count, RansSink& sink);
  /// Reads as many kinds of symbols, at most kMaxBatch.
  void (*read_slots)(VolumeSource& source, const SlotTable& slots, std::size_t count, std::uint8_t* kinds);
  /// Where a fault is found, the voxels mean nothing.
  VolumeFault (*read)(VolumeSource& source, const VolumeCode& code, PaddedVoxels& padded);
};

[[nodiscard]] VolumeKernels volume_kernels(InstructionSet set);

/// Those of instruction_set().
[[nodiscard]] const VolumeKernels& volume_kernels();

}  // namespace talus::codec
