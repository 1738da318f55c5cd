// What the store of edits keeps, as keys and values: FORMAT.md has every byte. Pure; any bytes are safe to
// decode.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <talus/edits/batch.h>
#include <talus/voxel/content_hash.h>

namespace talus::server {

using Bytes = std::vector<std::byte>;

/// The number that every value begins with. What is read has this one; meta alone may have another, which is
/// then told.
inline constexpr std::uint8_t kStoreFormat = 1;
/// Of meta's value, with its number and its checksum.
inline constexpr std::size_t kMetaBytes = 133;

/// Where a store stands in the stream that it shares with those of other servers.
struct StreamPlace {
  std::uint64_t sequence = 0;   // of the last message that is applied; 0: the store is in no cluster
  std::int64_t created_ns = 0;  // when the stream was made: another time is another stream
  std::int64_t looked_ms = 0;   // the time of messages up to which the stream's own clock was asked
  bool operator==(const StreamPlace&) const = default;
};

/// Where the store stands.
struct StoreMeta {
  ContentHash fingerprint;  // of the world
  ContentHash store_id;
  std::uint32_t level_rule = edits::kLevelRule;
  edits::Head head;
  std::uint64_t link = 0;  // of the log's record of head.position
  std::uint64_t flushed = 0;
  std::uint64_t flushed_link = 0;  // of the record of `flushed`: chunks and editors hold all up to it
  StreamPlace stream{};
  bool operator==(const StoreMeta&) const = default;
};

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

/// A chunk of any level. Without voxels where its last override went: the revision stays.
struct StoredChunk {
  std::uint64_t revision = 0;
  std::vector<Override> voxels;  // by rising index
  bool operator==(const StoredChunk&) const = default;
};

struct StoredEditor {
  std::uint64_t position = 0;  // the entry up to which it is
  edits::Editor editor;
  bool operator==(const StoredEditor&) const = default;
};

/// Records of the log that are flushed, and kept as history: dropped together.
struct HistorySegment {
  std::uint64_t first = 0;
  std::uint64_t last = 0;
  std::uint64_t bytes = 0;
  std::int64_t last_time_ms = 0;
  bool operator==(const HistorySegment&) const = default;
};

/// What was acknowledged, kept beside the database: where the database has less, it lost something.
struct Acknowledged {
  std::uint64_t position = 0;
  std::uint64_t link = 0;
  bool operator==(const Acknowledged&) const = default;
};

/// The first byte of a key.
enum class KeyKind : char { meta = 'm', editor = 'e', log = 'l', chunk = 'c', material = 'n', history = 'h' };

[[nodiscard]] std::string meta_key();
[[nodiscard]] std::string editor_key(edits::EditorId id);
[[nodiscard]] std::string log_key(std::uint64_t position);
/// The least key behind that: where a range of records begins that is deleted (rocks.cpp says why).
[[nodiscard]] std::string behind_log_key(std::uint64_t position);
[[nodiscard]] std::string chunk_key(ChunkKey chunk);
[[nodiscard]] std::string material_key(std::string_view name);
[[nodiscard]] std::string history_key(std::uint64_t first);

[[nodiscard]] std::optional<edits::EditorId> editor_of_key(std::string_view key);
[[nodiscard]] std::optional<std::uint64_t> position_of_key(std::string_view key);  // of log and history
[[nodiscard]] std::optional<ChunkKey> chunk_of_key(std::string_view key);
[[nodiscard]] std::optional<std::string_view> material_of_key(std::string_view key);

// Each replaces what `out` held. A value is bound to its key by its checksum.
void encode(const StoreMeta& meta, Bytes& out);
void encode(std::string_view key, std::uint64_t revision, std::span<const Override> voxels, Bytes& out);
void encode(std::string_view key, std::uint64_t position, const edits::Editor& editor, Bytes& out);
void encode(std::string_view key, const HistorySegment& segment, Bytes& out);
void encode(std::string_view key, MaterialId material, Bytes& out);
void encode(const Acknowledged& acknowledged, Bytes& out);
/// Returns the record's link: a hash of it and of the link of the record before.
std::uint64_t encode(const LogRecord& record, std::uint64_t link_before, Bytes& out);
/// The same of what a batch applied.
std::uint64_t encode(const edits::Applied& applied, std::int64_t time_ms, std::uint64_t link_before,
                     Bytes& out);

/// What a record of an edit has of them; no checksum.
void encode(std::span<const edits::ChunkChanges> changes, Bytes& out);
[[nodiscard]] std::optional<std::vector<edits::ChunkChanges>> decode_changes(
    std::span<const std::byte> bytes);

// Nothing where the bytes are damaged, or are not what encode() wrote for this key.
[[nodiscard]] std::optional<StoreMeta> decode_meta(std::span<const std::byte> value);
/// Whether the value is whole, and of another format or length: not damaged, but none that decode_meta()
/// knows.
[[nodiscard]] bool is_other_meta(std::span<const std::byte> value);
[[nodiscard]] std::optional<StoredChunk> decode_chunk_value(std::string_view key,
                                                            std::span<const std::byte> value);
/// Its checksum holds; its voxels are not looked at.
[[nodiscard]] std::optional<std::uint64_t> decode_chunk_revision(std::string_view key,
                                                                 std::span<const std::byte> value);
[[nodiscard]] std::optional<StoredEditor> decode_editor(std::string_view key,
                                                        std::span<const std::byte> value);
[[nodiscard]] std::optional<HistorySegment> decode_history(std::string_view key,
                                                           std::span<const std::byte> value);
[[nodiscard]] std::optional<MaterialId> decode_material(std::string_view key,
                                                        std::span<const std::byte> value);
[[nodiscard]] std::optional<Acknowledged> decode_acknowledged(std::span<const std::byte> value);
/// Of a record whose link is right for `link_before`, which becomes that of this record.
[[nodiscard]] std::optional<LogRecord> decode_record(std::span<const std::byte> value,
                                                     std::uint64_t& link_before);

/// Of a record whose neighbour before is not at hand: its link is taken as right, and returned. It finds
/// less.
[[nodiscard]] std::optional<LogRecord> decode_record_alone(std::span<const std::byte> value,
                                                           std::uint64_t& link);

}  // namespace talus::server
