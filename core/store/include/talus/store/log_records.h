// The log as the store keeps it: the entries of a batch in one value, as a database's work goes with the
// count of its values. FORMAT.md has every byte. Pure; any bytes are safe to decode.
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

/// An entry of the log and what became of it.
struct LogRecord {
  edits::Applied::Kind kind = edits::Applied::Kind::invalid;
  edits::EditorId editor;
  std::uint64_t position = 0;
  std::uint64_t revision = 0;  // of the state after it
  std::int64_t time_ms = 0;
  edits::EditResult result;                  // of done, conflict and repeat
  std::uint64_t epoch = 0;                   // of attached
  std::string subject;                       // of attached, and of done: whose edit it is
  std::optional<edits::EditorId> forgotten;  // of attached: who made place for it
  std::vector<edits::ChunkChanges> changes;  // of done: level 0, all other levels follow from it
  edits::NamedIds materials;                 // of bound
  bool operator==(const LogRecord&) const = default;
};

// Each replaces what `out` held, and returns the link of the batch: a hash of it and of the link of the one
// before. REQUIRES: there are entries, with positions and revisions that follow each other, of one time.
std::uint64_t encode(std::span<const edits::Applied> applied, std::int64_t time_ms, std::uint64_t link_before,
                     Bytes& out);
std::uint64_t encode(std::span<const LogRecord> records, std::uint64_t link_before, Bytes& out);

/// Of a batch whose link is right for `link_before`, which becomes that of this batch. Nothing where the
/// bytes are damaged, or are not what encode() wrote.
[[nodiscard]] std::optional<std::vector<LogRecord>> decode_records(std::span<const std::byte> value,
                                                                   std::uint64_t& link_before);
/// The same where the link before is not at hand: the checksum is not looked at. `link` becomes the batch's.
[[nodiscard]] std::optional<std::vector<LogRecord>> decode_records_alone(std::span<const std::byte> value,
                                                                         std::uint64_t& link);

/// What an entry of an edit has of them; no checksum.
void encode(std::span<const edits::ChunkChanges> changes, Bytes& out);
[[nodiscard]] std::optional<std::vector<edits::ChunkChanges>> decode_changes(
    std::span<const std::byte> bytes);

}  // namespace talus::store
