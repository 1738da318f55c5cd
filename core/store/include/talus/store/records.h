// Values of the edit store except its log; FORMAT.md specifies every byte. Pure; decodes any bytes safely.
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

/// Size of the meta value, including format number and checksum.
inline constexpr std::size_t kMetaBytes = 141;

/// A store's place in the stream shared by the servers of a cluster.
struct StreamPlace {
  std::uint64_t sequence = 0;      // last applied message; 0: not in a cluster
  std::int64_t created_ns = 0;     // creation time of the stream, which identifies it
  std::int64_t asked_ms = 0;       // the stream's clock was last consulted for this message time
  std::uint64_t message_hash = 0;  // hash of message `sequence`; another hash there means another stream
  bool operator==(const StreamPlace&) const = default;
};

/// The state of a store.
struct StoreMeta {
  ContentHash fingerprint;  // the world's
  ContentHash store_id;
  std::uint32_t level_rule = edits::kLevelRule;
  edits::Head head;
  std::uint64_t link = 0;  // link of the log's batch that ends at head.position
  std::uint64_t flushed = 0;
  std::uint64_t flushed_link = 0;  // link of the batch ending at `flushed`; chunks and editors include it
  StreamPlace stream{};
  bool operator==(const StoreMeta&) const = default;
};

/// A chunk of any level. Without voxels if its last override was removed; the revision stays.
struct StoredChunk {
  std::uint64_t revision = 0;
  std::vector<Override> voxels;  // by ascending index
  bool operator==(const StoredChunk&) const = default;
};

struct StoredEditor {
  std::uint64_t position = 0;  // the last entry included
  edits::Editor editor;
  bool operator==(const StoredEditor&) const = default;
};

/// Flushed records kept as history; dropped as a unit.
struct HistorySegment {
  std::uint64_t first = 0;
  std::uint64_t last = 0;
  std::uint64_t bytes = 0;
  std::int64_t last_time_ms = 0;
  bool operator==(const HistorySegment&) const = default;
};

/// Acknowledged state, stored next to the database: a database with less has lost data.
struct AcknowledgedState {
  std::uint64_t position = 0;
  std::uint64_t link = 0;
  bool operator==(const AcknowledgedState&) const = default;
};

// Each replaces the contents of `out`. A value is bound to its key by its checksum.
void encode(const StoreMeta& meta, Bytes& out);
void encode(std::string_view key, std::uint64_t revision, std::span<const Override> voxels, Bytes& out);
void encode(std::string_view key, std::uint64_t position, const edits::Editor& editor, Bytes& out);
void encode(std::string_view key, const HistorySegment& segment, Bytes& out);
void encode(std::string_view key, MaterialId material, Bytes& out);
void encode(const AcknowledgedState& acknowledged, Bytes& out);

// nullopt if the bytes are damaged or encode() cannot have written them for this key.
[[nodiscard]] std::optional<StoreMeta> decode_meta(std::span<const std::byte> value);
/// True for an intact value of another format or length, which decode_meta() cannot read.
[[nodiscard]] bool is_other_meta(std::span<const std::byte> value);
[[nodiscard]] std::optional<StoredChunk> decode_chunk_value(std::string_view key,
                                                            std::span<const std::byte> value);
/// Verifies the checksum, but not the voxels.
[[nodiscard]] std::optional<std::uint64_t> decode_chunk_revision(std::string_view key,
                                                                 std::span<const std::byte> value);
[[nodiscard]] std::optional<StoredEditor> decode_editor(std::string_view key,
                                                        std::span<const std::byte> value);
[[nodiscard]] std::optional<HistorySegment> decode_history(std::string_view key,
                                                           std::span<const std::byte> value);
[[nodiscard]] std::optional<MaterialId> decode_material(std::string_view key,
                                                        std::span<const std::byte> value);
[[nodiscard]] std::optional<AcknowledgedState> decode_acknowledged(std::span<const std::byte> value);

}  // namespace talus::store
