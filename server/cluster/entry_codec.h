// Encodes an entry of the log (FORMAT.md). Pure; decodes any bytes safely.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <talus/edits/settle.h>
#include <talus/store/records.h>

#include "edits/edit_log.h"

namespace talus::server::cluster {

/// Format of entries, part of kLogFormat. The set of valid entries of a format never changes: a changed bound
/// is a new format.
inline constexpr std::uint8_t kEntryFormat = 1;

/// Maximum number of generated voxels in an entry: those that an edit names, and those that may slide.
inline constexpr std::size_t kMaxBaseVoxels = edits::kMaxVoxels + edits::kSettleVoxels;
/// Maximum number of chunks of these voxels.
inline constexpr std::size_t kMaxBaseChunks = 128;
/// Maximum number of secret voxels in an entry: those of its generated voxels and the voxels beside them.
inline constexpr std::size_t kMaxSecretVoxels = 7 * kMaxBaseVoxels;
/// Maximum number of materials that hide nothing.
inline constexpr std::size_t kMaxSeeThrough = 1'024;
/// Maximum number of names in an entry.
inline constexpr std::size_t kMaxNames = 1'024;

enum class EntryFault : std::uint8_t {
  newer,    // unknown format, kind, or codec of its paste
  damaged,  // not written by any talusd
};

/// Appends the entry. Only the fact that it settles is encoded; the rules are in the message.
void encode(const LogEntry& entry, store::Bytes& out);

/// Decodes a complete entry; `settles` are the rules for one that settles. Checks counts before allocating.
[[nodiscard]] tl::expected<LogEntry, EntryFault> decode_entry(std::span<const std::byte> bytes,
                                                              const edits::SettleRulesPtr& settles);

}  // namespace talus::server::cluster
