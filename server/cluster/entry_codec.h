// An entry of the log as bytes: FORMAT.md. Pure; any bytes are safe to decode.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <talus/edits/settle.h>
#include <talus/store/records.h>

#include "edits/edit_log.h"

namespace talus::server::cluster {

/// Of entries: part of kLogFormat. What is an entry of a format stays so, and what is none: a bound that
/// changes is a new format.
inline constexpr std::uint8_t kEntryFormat = 1;

/// Voxels as generated that an entry carries: those that an edit names, and those that may slide.
inline constexpr std::size_t kMaxBaseVoxels = edits::kMaxVoxels + edits::kSettleVoxels;
/// Chunks of them.
inline constexpr std::size_t kMaxBaseChunks = 128;
/// Names of one entry.
inline constexpr std::size_t kMaxNames = 1'024;

enum class EntryFault : std::uint8_t {
  newer,    // its format, its kind, or the codec of what it pastes, is one that this talusd does not know
  damaged,  // no talusd wrote it
};

/// Appends it. By which rules it settles is the message's, and not written here: only whether it does.
void encode(const LogEntry& entry, store::Bytes& out);

/// A whole entry; `settles` for one that does. Counts are checked before memory is taken for them.
[[nodiscard]] tl::expected<LogEntry, EntryFault> decode_entry(std::span<const std::byte> bytes,
                                                              const edits::SettleRulesPtr& settles);

}  // namespace talus::server::cluster
