// The values of the store of edits but for its log: FORMAT.md has every byte. Pure; any bytes are safe to
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
#include <talus/store/sealed_value.h>
#include <talus/voxel/content_hash.h>

namespace talus::store {

/// Of meta's value, with its number and its checksum.
inline constexpr std::size_t kMetaBytes = 141;

/// Where a store stands in the stream that it shares with those of other servers.
struct StreamPlace {
  std::uint64_t sequence = 0;   // of the last message that is applied; 0: the store is in no cluster
  std::int64_t created_ns = 0;  // when the stream was made: another time is another stream
  std::int64_t looked_ms = 0;   // the time of messages up to which the stream's own clock was asked
  std::uint64_t message_hash =
      0;  // of that message: a stream that has another there is not the one that was read
  bool operator==(const StreamPlace&) const = default;
};

/// Where the store stands.
struct StoreMeta {
  ContentHash fingerprint;  // of the world
  ContentHash store_id;
  std::uint32_t level_rule = edits::kLevelRule;
  edits::Head head;
  std::uint64_t link = 0;  // of the log's batch up to head.position
  std::uint64_t flushed = 0;
  std::uint64_t flushed_link = 0;  // of the batch up to `flushed`: chunks and editors hold all up to it
  StreamPlace stream{};
  bool operator==(const StoreMeta&) const = default;
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

// Each replaces what `out` held. A value is bound to its key by its checksum.
void encode(const StoreMeta& meta, Bytes& out);
void encode(std::string_view key, std::uint64_t revision, std::span<const Override> voxels, Bytes& out);
void encode(std::string_view key, std::uint64_t position, const edits::Editor& editor, Bytes& out);
void encode(std::string_view key, const HistorySegment& segment, Bytes& out);
void encode(std::string_view key, MaterialId material, Bytes& out);
void encode(const Acknowledged& acknowledged, Bytes& out);

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

}  // namespace talus::store
