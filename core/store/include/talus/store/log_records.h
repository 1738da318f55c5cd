// The stored log: the entries of a batch form one value, because a database's cost grows with the number of
// values. FORMAT.md specifies every byte. Pure; decodes any bytes safely.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <talus/edits/batch.h>
#include <talus/store/sealed_value.h>

namespace talus::store {

/// An entry of the log and its outcome.
struct LogRecord {
  edits::EntryResult::Kind kind = edits::EntryResult::Kind::invalid;
  edits::EditorId editor;
  std::uint64_t position = 0;
  std::uint64_t revision = 0;  // after this entry
  std::int64_t time_ms = 0;
  edits::EditResult result;                  // for done, conflict and repeat
  std::uint64_t epoch = 0;                   // for attached
  std::string subject;                       // for attached and done: the editor's owner
  std::optional<edits::EditorId> forgotten;  // for attached: the editor evicted for it
  std::vector<edits::ChunkChanges> changes;  // for done: level 0; other levels follow from it
  edits::NamedIds materials;                 // for bound
  bool operator==(const LogRecord&) const = default;
};

// Replaces the contents of `out` and returns the link of the batch: a hash of it and of the link before it.
// REQUIRES: at least one entry, consecutive positions and revisions, one time.
std::uint64_t encode(std::span<const edits::EntryResult> applied, std::int64_t time_ms,
                     std::uint64_t link_before, Bytes& out);
std::uint64_t encode(std::span<const LogRecord> records, std::uint64_t link_before, Bytes& out);

/// Decodes a batch whose link fits `link_before`, which becomes the link of this batch. nullopt if the bytes
/// are damaged or encode() cannot have written them.
[[nodiscard]] std::optional<std::vector<LogRecord>> decode_records(std::span<const std::byte> value,
                                                                   std::uint64_t& link_before);
/// For an unknown previous link: ignores the checksum. `link` becomes the batch's link.
[[nodiscard]] std::optional<std::vector<LogRecord>> decode_records_alone(std::span<const std::byte> value,
                                                                         std::uint64_t& link);

/// The changes part of an edit's entry, without a checksum.
void encode(std::span<const edits::ChunkChanges> changes, Bytes& out);
[[nodiscard]] std::optional<std::vector<edits::ChunkChanges>> decode_changes(
    std::span<const std::byte> bytes);

}  // namespace talus::store
