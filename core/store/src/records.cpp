#include <talus/store/records.h>

#include <utility>

#include <talus/edits/runs.h>
#include <talus/store/keys.h>

#include "stored_result.h"

namespace talus::store {
namespace {

constexpr std::string_view kAcknowledgedKey = "acknowledged";

void put_hash(ContentHash hash, ByteWriter& out) {
  out.fixed64(hash.low);
  out.fixed64(hash.high);
}
ContentHash get_hash(ByteReader& in) {
  const std::uint64_t low = in.fixed64();
  return {low, in.fixed64()};
}

}  // namespace

void encode(const StoreMeta& meta, Bytes& out) {
  ByteWriter writer = begin_value(out);
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
  writer.fixed64(static_cast<std::uint64_t>(meta.stream.asked_ms));
  writer.fixed64(meta.stream.message_hash);
  seal(hash_of(meta_key()), out);
}

void encode(std::string_view key, std::uint64_t revision, std::span<const Override> voxels, Bytes& out) {
  ByteWriter writer = begin_value(out);
  writer.varint(revision);
  edits::encode_runs(voxels, out);
  seal(hash_of(key), out);
}

void encode(std::string_view key, std::uint64_t position, const edits::Editor& editor, Bytes& out) {
  ByteWriter writer = begin_value(out);
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
  ByteWriter writer = begin_value(out);
  writer.varint(segment.first);
  writer.varint(segment.last);
  writer.varint(segment.bytes);
  writer.varint(static_cast<std::uint64_t>(segment.last_time_ms));
  seal(hash_of(key), out);
}

void encode(std::string_view key, MaterialId material, Bytes& out) {
  ByteWriter writer = begin_value(out);
  writer.varint(to_integer(material));
  seal(hash_of(key), out);
}

void encode(const AcknowledgedState& acknowledged, Bytes& out) {
  ByteWriter writer = begin_value(out);
  writer.fixed64(acknowledged.position);
  writer.fixed64(acknowledged.link);
  seal(hash_of(kAcknowledgedKey), out);
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
  meta.stream.asked_ms = static_cast<std::int64_t>(in.fixed64());
  meta.stream.message_hash = in.fixed64();
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

std::optional<AcknowledgedState> decode_acknowledged(std::span<const std::byte> value) {
  const auto body = sealed(hash_of(kAcknowledgedKey), value);
  if (!body) return std::nullopt;
  ByteReader in{*body};
  AcknowledgedState acknowledged;
  acknowledged.position = in.fixed64();
  acknowledged.link = in.fixed64();
  return in.ended() ? std::optional{acknowledged} : std::nullopt;
}

}  // namespace talus::store
