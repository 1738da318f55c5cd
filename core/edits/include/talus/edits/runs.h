// Encodes voxels of one chunk as bytes, for the store, the log and the wire: ../../../FORMAT.md, "Runs". The
// encoding of a set of voxels is unique, so equal sets have equal bytes and equal hashes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include <talus/voxel/chunk.h>

namespace talus::edits {

enum class RunsError : std::uint8_t {
  truncated,      // the bytes end before the runs do
  too_long,       // bytes follow the last run
  bad_number,     // a varint is out of range or has more bytes than it needs
  bad_materials,  // the ids do not ascend, or the list of ids does not match the runs
  split_run,      // a run has the material of an adjacent run
  past_chunk,     // a run ends after the chunk's last voxel
  too_many,       // more voxels than the caller accepts
};

/// One line for humans: the error and what is expected.
[[nodiscard]] std::string_view describe(RunsError error);

/// Appends `voxels`. REQUIRES: indices ascend without duplicates, below kChunkVolume (asserted).
void encode_runs(std::span<const Override> voxels, std::vector<std::byte>& out);

/// Decodes a complete block. Safe for any bytes: anything that encode_runs() would not write is an error, and
/// counts are checked against the remaining bytes before memory is allocated. The result, by ascending index,
/// has at most `max_voxels` voxels, which are counted before they are expanded.
[[nodiscard]] tl::expected<std::vector<Override>, RunsError> decode_runs(
    std::span<const std::byte> bytes, std::size_t max_voxels = kChunkVolume);

}  // namespace talus::edits
