#include <talus/store/log_records.h>

#include <algorithm>
#include <array>
#include <utility>

#include <talus/edits/runs.h>
#include <talus/store/sealed_value.h>

#include "stored_result.h"

namespace talus::store {
namespace {

bool has_result(edits::EntryResult::Kind kind) {
  using Kind = edits::EntryResult::Kind;
  return kind == Kind::done || kind == Kind::conflict || kind == Kind::repeat;
}

std::vector<Override> get_runs(ByteReader& in) {
  auto voxels = edits::decode_runs(in.counted());
  if (!voxels) in.fail();
  return in.ok() ? std::move(*voxels) : std::vector<Override>{};
}

/// Encodes three values per voxel: before, after, and as generated.
void put_changes(const edits::ChunkChanges& changes, ByteWriter& out) {
  for (const std::int32_t at : {changes.chunk.x, changes.chunk.y, changes.chunk.z}) out.zigzag(at);
  std::array<Override, 8> few;  // enough for most edits
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

/// Encodes an EntryResult or a LogRecord. Omits fields that are equal in a whole batch or follow from the
/// entries before.
template <typename Record>
void put_record(const Record& record, ByteWriter& out) {
  using Kind = edits::EntryResult::Kind;
  out.byte(static_cast<std::uint8_t>(record.kind));
  out.fixed64(record.editor.low);
  out.fixed64(record.editor.high);
  if (has_result(record.kind)) put_result(record.result, out);
  if (record.kind == Kind::attached) {
    out.varint(record.epoch);
    out.counted(record.subject);
    out.byte(record.forgotten ? 1 : 0);
    if (record.forgotten) {
      out.fixed64(record.forgotten->low);
      out.fixed64(record.forgotten->high);
    }
  }
  if (record.kind == Kind::done) {
    out.counted(record.subject);
    put_all_changes(record.changes, out);
  }
  if (record.kind == Kind::bound) put_named_ids(record.materials, out);
}
LogRecord get_record(ByteReader& in) {
  using Kind = edits::EntryResult::Kind;
  LogRecord record;
  const std::uint8_t kind = in.byte();
  if (kind > static_cast<std::uint8_t>(Kind::bound)) in.fail();
  record.kind = static_cast<Kind>(kind);
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
  return record;
}

std::uint64_t revisions_of(const auto& record) {
  return record.changes.empty() ? 0 : 1;
}

template <typename Record>
std::uint64_t encode_entries(std::span<const Record> records, std::int64_t time_ms, std::uint64_t link_before,
                             Bytes& out) {
  ByteWriter writer = begin_value(out);
  writer.varint(records.back().position);
  writer.varint(records.size());
  writer.varint(records.front().revision - revisions_of(records.front()));
  writer.varint(static_cast<std::uint64_t>(time_ms));
  for (const Record& record : records) put_record(record, writer);
  return seal(link_before, out);
}

std::optional<std::vector<LogRecord>> read_entries(std::span<const std::byte> body) {
  ByteReader in{body};
  const std::uint64_t last = in.varint();
  const std::size_t count = in.count();
  std::uint64_t revision = in.varint();
  const auto time_ms = static_cast<std::int64_t>(in.varint(INT64_MAX));
  if (count == 0 || count > last) in.fail();
  std::vector<LogRecord> records;
  for (std::uint64_t left = count; left > 0 && in.ok(); --left) {
    LogRecord& record = records.emplace_back(get_record(in));
    record.position = last - left + 1;
    record.revision = revision += revisions_of(record);
    record.time_ms = time_ms;
  }
  return in.ended() ? std::optional{std::move(records)} : std::nullopt;
}

}  // namespace

std::uint64_t encode(std::span<const edits::EntryResult> applied, std::int64_t time_ms,
                     std::uint64_t link_before, Bytes& out) {
  return encode_entries(applied, time_ms, link_before, out);
}

std::uint64_t encode(std::span<const LogRecord> records, std::uint64_t link_before, Bytes& out) {
  return encode_entries(records, records.front().time_ms, link_before, out);
}

std::optional<std::vector<LogRecord>> decode_records(std::span<const std::byte> value,
                                                     std::uint64_t& link_before) {
  const auto body = sealed(link_before, value);
  if (!body) return std::nullopt;
  auto records = read_entries(*body);
  if (records) link_before = ByteReader{value.last(kChecksumBytes)}.fixed64();
  return records;
}

std::optional<std::vector<LogRecord>> decode_records_alone(std::span<const std::byte> value,
                                                           std::uint64_t& link) {
  if (value.size() <= kChecksumBytes || std::to_integer<std::uint8_t>(value.front()) != kStoreFormat) {
    return std::nullopt;
  }
  auto records = read_entries(value.subspan(1, value.size() - 1 - kChecksumBytes));
  if (records) link = ByteReader{value.last(kChecksumBytes)}.fixed64();
  return records;
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

}  // namespace talus::store
