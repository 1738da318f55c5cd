#include "store/records.h"

#include <algorithm>
#include <array>
#include <utility>

#include <talus/edits/runs.h>
#include <xxhash.h>

#include "store/bytes.h"

namespace talus::server {
namespace {

constexpr std::size_t kChecksumBytes = 8;
constexpr std::string_view kAcknowledgedKey = "acknowledged";

std::uint64_t hash_of(std::string_view text) {
  return XXH3_64bits(text.data(), text.size());
}

/// The XXH3-64 of a value, seeded by that of its key, so that no value passes for another's.
void seal(std::uint64_t seed, Bytes& out) {
  ByteWriter{out}.fixed64(XXH3_64bits_withSeed(out.data(), out.size(), seed));
}

/// What seal() sealed, of whatever format, or nothing.
std::optional<std::span<const std::byte>> sealed_bytes(std::uint64_t seed, std::span<const std::byte> value) {
  if (value.size() <= kChecksumBytes) return std::nullopt;
  const auto body = value.first(value.size() - kChecksumBytes);
  const std::uint64_t held = ByteReader{value.last(kChecksumBytes)}.fixed64();
  if (held != XXH3_64bits_withSeed(body.data(), body.size(), seed)) return std::nullopt;
  return body;
}

/// The same behind its number of the format, where that is this one.
std::optional<std::span<const std::byte>> sealed(std::uint64_t seed, std::span<const std::byte> value) {
  const auto body = sealed_bytes(seed, value);
  if (!body || std::to_integer<std::uint8_t>(body->front()) != kStoreFormat) return std::nullopt;
  return body->subspan(1);
}

ByteWriter begin(Bytes& out) {
  out.clear();
  ByteWriter writer{out};
  writer.byte(kStoreFormat);
  return writer;
}

/// Big endian, so that keys are in the numbers' order.
void put_ordered(std::uint64_t value, int bytes, std::string& key) {
  std::array<char, 8> all;
  for (int i = 0; i < bytes; ++i)
    all[static_cast<std::size_t>(i)] = static_cast<char>(value >> (8 * (bytes - 1 - i)));
  key.append(all.data(), static_cast<std::size_t>(bytes));
}
std::uint64_t get_ordered(std::string_view bytes) {
  std::uint64_t value = 0;
  for (const char byte : bytes) value = (value << 8) | static_cast<unsigned char>(byte);
  return value;
}

std::string begin_key(KeyKind kind) {
  return std::string(1, static_cast<char>(kind));
}

bool is_key(std::string_view key, KeyKind kind, std::size_t bytes) {
  return key.size() == 1 + bytes && key.front() == static_cast<char>(kind);
}

/// Coordinates in order: the sign's bit is flipped.
constexpr std::uint32_t kSign = 0x8000'0000;
std::uint32_t ordered(std::int32_t at) {
  return static_cast<std::uint32_t>(at) ^ kSign;
}
std::int32_t unordered(std::uint64_t value) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(value) ^ kSign);
}

void put_hash(ContentHash hash, ByteWriter& out) {
  out.fixed64(hash.low);
  out.fixed64(hash.high);
}
ContentHash get_hash(ByteReader& in) {
  const std::uint64_t low = in.fixed64();
  return {low, in.fixed64()};
}

void put_result(const edits::EditResult& result, ByteWriter& out) {
  out.varint(result.sequence);
  out.varint(result.revision);
  out.varint(result.changed);
  out.varint(result.conflict ? std::uint64_t{*result.conflict} + 1 : 0);
}
edits::EditResult get_result(ByteReader& in) {
  edits::EditResult result;
  result.sequence = in.varint();
  result.revision = in.varint();
  result.changed = static_cast<std::uint32_t>(in.varint(UINT32_MAX));
  const std::uint64_t conflict = in.varint(std::uint64_t{UINT32_MAX} + 1);
  if (conflict > 0) result.conflict = static_cast<std::uint32_t>(conflict - 1);
  return result;
}

bool has_result(edits::Applied::Kind kind) {
  using Kind = edits::Applied::Kind;
  return kind == Kind::done || kind == Kind::conflict || kind == Kind::repeat;
}

std::vector<Override> get_runs(ByteReader& in) {
  auto voxels = edits::decode_runs(in.counted());
  if (!voxels) in.fail();
  return in.ok() ? std::move(*voxels) : std::vector<Override>{};
}

/// What changed, as three sets of the same voxels: before, after, and as generated.
void put_changes(const edits::ChunkChanges& changes, ByteWriter& out) {
  for (const std::int32_t at : {changes.chunk.x, changes.chunk.y, changes.chunk.z}) out.zigzag(at);
  std::array<Override, 8> few;  // mostly
  std::vector<Override> many;
  std::span<Override> voxels{few};
  if (changes.voxels.size() > few.size()) {
    many.resize(changes.voxels.size());
    voxels = many;
  }
  voxels = voxels.first(changes.voxels.size());
  for (const auto material :
       {&edits::VoxelChange::before, &edits::VoxelChange::after, &edits::VoxelChange::base}) {
    std::ranges::transform(changes.voxels, voxels.begin(), [material](const edits::VoxelChange& voxel) {
      return Override{voxel.index, voxel.*material};
    });
    out.counted_by([&](Bytes& bytes) { edits::encode_runs(voxels, bytes); });
  }
}
edits::ChunkChanges get_changes(ByteReader& in) {
  edits::ChunkChanges changes;
  for (std::int32_t* const at : {&changes.chunk.x, &changes.chunk.y, &changes.chunk.z}) {
    *at = static_cast<std::int32_t>(in.zigzag(UINT32_MAX));
  }
  const auto before = get_runs(in);
  const auto after = get_runs(in);
  const auto base = get_runs(in);
  const auto same = [&](const std::vector<Override>& other) {
    return std::ranges::equal(before, other, {}, &Override::index, &Override::index);
  };
  if (before.empty() || !same(after) || !same(base)) in.fail();
  if (!in.ok()) return {};
  changes.voxels.reserve(before.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    changes.voxels.push_back({before[i].index, before[i].material, after[i].material, base[i].material});
    if (before[i].material == after[i].material) in.fail();
  }
  return changes;
}

void put_all_changes(std::span<const edits::ChunkChanges> changes, ByteWriter& out) {
  out.varint(changes.size());
  for (const edits::ChunkChanges& each : changes) put_changes(each, out);
}
std::vector<edits::ChunkChanges> get_all_changes(ByteReader& in) {
  std::vector<edits::ChunkChanges> changes;
  const std::uint64_t chunks = in.varint(edits::kMaxChunks);
  for (std::uint64_t i = 0; i < chunks && in.ok(); ++i) {
    changes.push_back(get_changes(in));
    if (i > 0 && changes[i - 1].chunk >= changes[i].chunk) in.fail();
  }
  return changes;
}

void put_named_ids(const edits::NamedIds& materials, ByteWriter& out) {
  out.varint(materials.size());
  for (const auto& [name, id] : materials) {
    out.counted(name);
    out.varint(to_integer(id));
  }
}
edits::NamedIds get_named_ids(ByteReader& in) {
  edits::NamedIds materials;
  for (std::size_t left = in.count(); left > 0 && in.ok(); --left) {
    std::string name = in.text(edits::kMaxMaterialNameBytes);
    const auto id = static_cast<std::uint16_t>(in.varint(UINT16_MAX));
    if (id < edits::kFirstBound) in.fail();
    materials.emplace_back(std::move(name), MaterialId{id});
  }
  return materials;
}

std::uint64_t encode_record(const edits::Applied& applied, std::span<const edits::ChunkChanges> changes,
                            std::int64_t time_ms, std::uint64_t link_before, Bytes& out) {
  ByteWriter writer = begin(out);
  writer.byte(static_cast<std::uint8_t>(applied.kind));
  writer.varint(applied.position);
  writer.varint(applied.revision);
  writer.varint(static_cast<std::uint64_t>(time_ms));
  writer.fixed64(applied.editor.low);
  writer.fixed64(applied.editor.high);
  if (has_result(applied.kind)) put_result(applied.result, writer);
  if (applied.kind == edits::Applied::Kind::attached) {
    writer.varint(applied.epoch);
    writer.counted(applied.subject);
    writer.byte(applied.forgotten ? 1 : 0);
    if (applied.forgotten) {
      writer.fixed64(applied.forgotten->low);
      writer.fixed64(applied.forgotten->high);
    }
  }
  if (applied.kind == edits::Applied::Kind::done) {
    writer.counted(applied.subject);
    put_all_changes(changes, writer);
  }
  if (applied.kind == edits::Applied::Kind::bound) put_named_ids(applied.materials, writer);
  seal(link_before, out);
  return ByteReader{std::span{std::as_const(out)}.last(kChecksumBytes)}.fixed64();
}

std::optional<LogRecord> read_record(std::span<const std::byte> body) {
  using Kind = edits::Applied::Kind;
  ByteReader in{body};
  LogRecord record;
  const std::uint8_t kind = in.byte();
  if (kind > static_cast<std::uint8_t>(Kind::bound)) in.fail();
  record.kind = static_cast<Kind>(kind);
  record.position = in.varint();
  record.revision = in.varint();
  record.time_ms = static_cast<std::int64_t>(in.varint(INT64_MAX));
  record.editor.low = in.fixed64();
  record.editor.high = in.fixed64();
  if (has_result(record.kind)) record.result = get_result(in);
  if (record.kind == Kind::attached) record.epoch = in.varint();
  if (record.kind == Kind::attached || record.kind == Kind::done) {
    record.subject = in.text(edits::kMaxSubjectBytes);
  }
  if (record.kind == Kind::attached) {
    const std::uint8_t forgets = in.byte();
    if (forgets > 1) in.fail();
    if (forgets == 1) {
      const std::uint64_t low = in.fixed64();
      record.forgotten = edits::EditorId{low, in.fixed64()};
    }
  }
  if (record.kind == Kind::done) record.changes = get_all_changes(in);
  if (record.kind == Kind::bound) record.materials = get_named_ids(in);
  if (!in.ended()) return std::nullopt;
  return record;
}

}  // namespace

std::string meta_key() {
  return begin_key(KeyKind::meta);
}
std::string editor_key(edits::EditorId id) {
  std::string key = begin_key(KeyKind::editor);
  put_ordered(id.high, 8, key);
  put_ordered(id.low, 8, key);
  return key;
}
std::string log_key(std::uint64_t position) {
  std::string key = begin_key(KeyKind::log);
  put_ordered(position, 8, key);
  return key;
}
std::string behind_log_key(std::uint64_t position) {
  return log_key(position) + '\0';
}
std::string chunk_key(ChunkKey chunk) {
  std::string key = begin_key(KeyKind::chunk);
  put_ordered(static_cast<std::uint64_t>(chunk.lod.value()), 1, key);
  for (const std::int32_t at : {chunk.coord.x, chunk.coord.z, chunk.coord.y})
    put_ordered(ordered(at), 4, key);
  return key;
}
std::string material_key(std::string_view name) {
  return begin_key(KeyKind::material) + std::string{name};
}
std::string history_key(std::uint64_t first) {
  std::string key = begin_key(KeyKind::history);
  put_ordered(first, 8, key);
  return key;
}

std::optional<edits::EditorId> editor_of_key(std::string_view key) {
  if (!is_key(key, KeyKind::editor, 16)) return std::nullopt;
  return edits::EditorId{.low = get_ordered(key.substr(9, 8)), .high = get_ordered(key.substr(1, 8))};
}
std::optional<std::uint64_t> position_of_key(std::string_view key) {
  if (!is_key(key, KeyKind::log, 8) && !is_key(key, KeyKind::history, 8)) return std::nullopt;
  return get_ordered(key.substr(1, 8));
}
std::optional<ChunkKey> chunk_of_key(std::string_view key) {
  if (!is_key(key, KeyKind::chunk, 13)) return std::nullopt;
  const auto lod = Lod::checked(static_cast<std::int64_t>(get_ordered(key.substr(1, 1))));
  if (!lod) return std::nullopt;
  const auto at = [&](std::size_t from) { return unordered(get_ordered(key.substr(from, 4))); };
  const auto chunk = checked_chunk(at(2), at(10), at(6), *lod);
  return chunk ? std::optional{*chunk} : std::nullopt;
}
std::optional<std::string_view> material_of_key(std::string_view key) {
  if (key.size() < 2 || key.front() != static_cast<char>(KeyKind::material)) return std::nullopt;
  return key.substr(1);
}

void encode(const StoreMeta& meta, Bytes& out) {
  ByteWriter writer = begin(out);
  put_hash(meta.fingerprint, writer);
  put_hash(meta.store_id, writer);
  writer.fixed32(meta.level_rule);
  writer.fixed64(meta.head.position);
  writer.fixed64(meta.head.revision);
  writer.fixed64(static_cast<std::uint64_t>(meta.head.time_ms));
  writer.fixed64(meta.head.hash.low);
  writer.fixed64(meta.head.hash.high);
  writer.fixed64(meta.link);
  writer.fixed64(meta.flushed);
  writer.fixed64(meta.flushed_link);
  writer.fixed64(meta.stream.sequence);
  writer.fixed64(static_cast<std::uint64_t>(meta.stream.created_ns));
  writer.fixed64(static_cast<std::uint64_t>(meta.stream.looked_ms));
  seal(hash_of(meta_key()), out);
}

void encode(std::string_view key, std::uint64_t revision, std::span<const Override> voxels, Bytes& out) {
  ByteWriter writer = begin(out);
  writer.varint(revision);
  edits::encode_runs(voxels, out);
  seal(hash_of(key), out);
}

void encode(std::string_view key, std::uint64_t position, const edits::Editor& editor, Bytes& out) {
  ByteWriter writer = begin(out);
  writer.varint(position);
  writer.varint(editor.epoch);
  writer.varint(editor.last_sequence);
  writer.varint(static_cast<std::uint64_t>(editor.used_ms));
  writer.counted(editor.subject);
  writer.varint(editor.results.size());
  for (const edits::EditResult& result : editor.results) put_result(result, writer);
  seal(hash_of(key), out);
}

void encode(std::string_view key, const HistorySegment& segment, Bytes& out) {
  ByteWriter writer = begin(out);
  writer.varint(segment.first);
  writer.varint(segment.last);
  writer.varint(segment.bytes);
  writer.varint(static_cast<std::uint64_t>(segment.last_time_ms));
  seal(hash_of(key), out);
}

void encode(std::string_view key, MaterialId material, Bytes& out) {
  ByteWriter writer = begin(out);
  writer.varint(to_integer(material));
  seal(hash_of(key), out);
}

void encode(const Acknowledged& acknowledged, Bytes& out) {
  ByteWriter writer = begin(out);
  writer.fixed64(acknowledged.position);
  writer.fixed64(acknowledged.link);
  seal(hash_of(kAcknowledgedKey), out);
}

std::uint64_t encode(const LogRecord& record, std::uint64_t link_before, Bytes& out) {
  edits::Applied applied;
  applied.kind = record.kind;
  applied.editor = record.editor;
  applied.position = record.position;
  applied.revision = record.revision;
  applied.result = record.result;
  applied.epoch = record.epoch;
  applied.subject = record.subject;
  applied.forgotten = record.forgotten;
  applied.materials = record.materials;
  return encode_record(applied, record.changes, record.time_ms, link_before, out);
}

std::uint64_t encode(const edits::Applied& applied, std::int64_t time_ms, std::uint64_t link_before,
                     Bytes& out) {
  return encode_record(applied, applied.changes, time_ms, link_before, out);
}

void encode(std::span<const edits::ChunkChanges> changes, Bytes& out) {
  out.clear();
  ByteWriter writer{out};
  put_all_changes(changes, writer);
}

std::optional<std::vector<edits::ChunkChanges>> decode_changes(std::span<const std::byte> bytes) {
  ByteReader in{bytes};
  auto changes = get_all_changes(in);
  return in.ended() ? std::optional{std::move(changes)} : std::nullopt;
}

std::optional<StoreMeta> decode_meta(std::span<const std::byte> value) {
  const auto body = sealed(hash_of(meta_key()), value);
  if (!body) return std::nullopt;
  ByteReader in{*body};
  StoreMeta meta;
  meta.fingerprint = get_hash(in);
  meta.store_id = get_hash(in);
  meta.level_rule = in.fixed32();
  meta.head.position = in.fixed64();
  meta.head.revision = in.fixed64();
  meta.head.time_ms = static_cast<std::int64_t>(in.fixed64());
  meta.head.hash.low = in.fixed64();
  meta.head.hash.high = in.fixed64();
  meta.link = in.fixed64();
  meta.flushed = in.fixed64();
  meta.flushed_link = in.fixed64();
  meta.stream.sequence = in.fixed64();
  meta.stream.created_ns = static_cast<std::int64_t>(in.fixed64());
  meta.stream.looked_ms = static_cast<std::int64_t>(in.fixed64());
  if (!in.ended() || meta.flushed > meta.head.position) return std::nullopt;
  return meta;
}

bool is_other_meta(std::span<const std::byte> value) {
  const auto body = sealed_bytes(hash_of(meta_key()), value);
  return body && (std::to_integer<std::uint8_t>(body->front()) != kStoreFormat || value.size() != kMetaBytes);
}

std::optional<StoredChunk> decode_chunk_value(std::string_view key, std::span<const std::byte> value) {
  const auto body = sealed(hash_of(key), value);
  if (!body) return std::nullopt;
  ByteReader in{*body};
  StoredChunk chunk;
  chunk.revision = in.varint();
  if (!in.ok()) return std::nullopt;
  Bytes number;
  ByteWriter{number}.varint(chunk.revision);
  auto voxels = edits::decode_runs(body->subspan(number.size()));
  if (!voxels) return std::nullopt;
  chunk.voxels = std::move(*voxels);
  return chunk;
}

std::optional<std::uint64_t> decode_chunk_revision(std::string_view key, std::span<const std::byte> value) {
  const auto body = sealed(hash_of(key), value);
  if (!body) return std::nullopt;
  ByteReader in{*body};
  const std::uint64_t revision = in.varint();
  return in.ok() ? std::optional{revision} : std::nullopt;
}

std::optional<StoredEditor> decode_editor(std::string_view key, std::span<const std::byte> value) {
  const auto body = sealed(hash_of(key), value);
  if (!body) return std::nullopt;
  ByteReader in{*body};
  StoredEditor stored;
  stored.position = in.varint();
  edits::Editor& editor = stored.editor;
  editor.epoch = in.varint();
  editor.last_sequence = in.varint();
  editor.used_ms = static_cast<std::int64_t>(in.varint(INT64_MAX));
  editor.subject = in.text(edits::kMaxSubjectBytes);
  const std::uint64_t results = in.varint(edits::kKeptResults);
  for (std::uint64_t i = 0; i < results && in.ok(); ++i) {
    editor.results.push_back(get_result(in));
    if (i > 0 && editor.results[i - 1].sequence >= editor.results[i].sequence) in.fail();
  }
  if (!editor.results.empty() && editor.results.back().sequence != editor.last_sequence) in.fail();
  return in.ended() ? std::optional{std::move(stored)} : std::nullopt;
}

std::optional<HistorySegment> decode_history(std::string_view key, std::span<const std::byte> value) {
  const auto body = sealed(hash_of(key), value);
  if (!body) return std::nullopt;
  ByteReader in{*body};
  HistorySegment segment;
  segment.first = in.varint();
  segment.last = in.varint();
  segment.bytes = in.varint();
  segment.last_time_ms = static_cast<std::int64_t>(in.varint(INT64_MAX));
  if (!in.ended() || segment.last < segment.first) return std::nullopt;
  return segment;
}

std::optional<MaterialId> decode_material(std::string_view key, std::span<const std::byte> value) {
  const auto body = sealed(hash_of(key), value);
  if (!body) return std::nullopt;
  ByteReader in{*body};
  const auto material = static_cast<std::uint16_t>(in.varint(UINT16_MAX));
  return in.ended() ? std::optional{MaterialId{material}} : std::nullopt;
}

std::optional<Acknowledged> decode_acknowledged(std::span<const std::byte> value) {
  const auto body = sealed(hash_of(kAcknowledgedKey), value);
  if (!body) return std::nullopt;
  ByteReader in{*body};
  Acknowledged acknowledged;
  acknowledged.position = in.fixed64();
  acknowledged.link = in.fixed64();
  return in.ended() ? std::optional{acknowledged} : std::nullopt;
}

std::optional<LogRecord> decode_record(std::span<const std::byte> value, std::uint64_t& link_before) {
  const auto body = sealed(link_before, value);
  if (!body) return std::nullopt;
  auto record = read_record(*body);
  if (record) link_before = ByteReader{value.last(kChecksumBytes)}.fixed64();
  return record;
}

std::optional<LogRecord> decode_record_alone(std::span<const std::byte> value, std::uint64_t& link) {
  if (value.size() <= kChecksumBytes || std::to_integer<std::uint8_t>(value.front()) != kStoreFormat) {
    return std::nullopt;
  }
  auto record = read_record(value.subspan(1, value.size() - 1 - kChecksumBytes));
  if (record) link = ByteReader{value.last(kChecksumBytes)}.fixed64();
  return record;
}

}  // namespace talus::server
