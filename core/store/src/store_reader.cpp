#include <talus/store/store_reader.h>

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <talus/store/rocks.h>

namespace talus::store {

tl::unexpected<std::string> StoreReader::failure(std::string_view what) const {
  return tl::unexpected{fmt::format("edits {}: {}", path_.string(), what)};
}

StoreReader::Result<std::optional<StoreMeta>> StoreReader::meta() const {
  std::string value;
  const auto status = db_.Get({}, meta_key(), &value);
  if (status.IsNotFound()) return std::nullopt;
  if (!status.ok()) return failure(fmt::format("{}; {}", status.ToString(), remedy_for(status)));
  if (!value.empty() && static_cast<std::uint8_t>(value.front()) > kStoreFormat) {
    return failure(
        fmt::format("the store has format {}; this talusd reads format {}; run a newer talusd, or give "
                    "--data another directory",
                    static_cast<std::uint8_t>(value.front()), kStoreFormat));
  }
  const auto bytes = std::as_bytes(std::span{value});
  const auto meta = decode_meta(bytes);
  if (meta) return meta;
  // A backup probably has the same format.
  if (is_other_meta(bytes)) {
    return failure(fmt::format(
        "another version of talusd wrote the store: its record of the store's state is whole, with format "
        "{} and {} bytes; this talusd reads format {} with {}; run the talusd that wrote it, carry the edits "
        "over by its `talusd store export` and this one's `talusd store import`, or give --data another "
        "directory",
        static_cast<std::uint8_t>(value.front()), value.size(), kStoreFormat, kMetaBytes));
  }
  return failure(fmt::format("its record of the store's state is damaged; {}", kStoreLost));
}

StoreReader::Result<std::map<std::string, MaterialId>> StoreReader::materials() const {
  std::map<std::string, MaterialId> materials;
  bool sound = true;
  const auto status = scan(db_, prefix_of(KeyKind::material), [&](const auto& key, const auto& value) {
    const auto name = material_of_key(text_of(key));
    const auto material = decode_material(text_of(key), bytes_of(value));
    sound = name && material;
    if (sound) materials.emplace(*name, *material);
    return sound;
  });
  if (!sound) return failure(fmt::format("its table of materials is damaged; {}", kStoreLost));
  if (!status.ok()) return failure(fmt::format("{}; {}", status.ToString(), remedy_for(status)));
  return materials;
}

StoreReader::Result<std::deque<HistorySegment>> StoreReader::history(std::uint64_t flushed) const {
  std::deque<HistorySegment> history;
  bool sound = true;
  const auto status = scan(db_, prefix_of(KeyKind::history), [&](const auto& key, const auto& value) {
    const auto segment = decode_history(text_of(key), bytes_of(value));
    sound =
        segment && segment->last <= flushed && (history.empty() || history.back().last + 1 == segment->first);
    if (sound) history.push_back(*segment);
    return sound;
  });
  if (!sound) return failure(fmt::format("its table of history is damaged; {}", kStoreLost));
  if (!status.ok()) return failure(fmt::format("{}; {}", status.ToString(), remedy_for(status)));
  return history;
}

StoreReader::Status StoreReader::for_each_chunk(
    const std::function<void(ChunkKey, std::uint64_t)>& visit) const {
  std::string damaged;
  const auto status = scan(db_, prefix_of(KeyKind::chunk), [&](const auto& key, const auto& value) {
    const auto chunk = chunk_of_key(text_of(key));
    const auto revision = decode_chunk_revision(text_of(key), bytes_of(value));
    if (!chunk || !revision) {
      damaged = chunk ? "chunk " + to_string(*chunk) : "the key of a chunk";
      return false;
    }
    visit(*chunk, *revision);
    return true;
  });
  if (!damaged.empty()) return failure(fmt::format("{} is damaged; {}", damaged, kStoreLost));
  if (!status.ok()) return failure(fmt::format("{}; {}", status.ToString(), remedy_for(status)));
  return {};
}

StoreReader::Status StoreReader::for_each_chunk_value(
    ChunkKey first, const std::function<bool(ChunkKey, StoredChunk&&)>& visit) const {
  std::string damaged;
  const auto status = scan(db_, chunk_key(first), [&](const auto& key, const auto& value) {
    const auto chunk = chunk_of_key(text_of(key));
    auto stored = decode_chunk_value(text_of(key), bytes_of(value));
    if (!chunk || !stored) {
      damaged = chunk ? "chunk " + to_string(*chunk) : "the key of a chunk";
      return false;
    }
    return visit(*chunk, *std::move(stored));
  });
  if (!damaged.empty()) return failure(fmt::format("{} is damaged; {}", damaged, kStoreLost));
  if (!status.ok()) return failure(fmt::format("{}; {}", status.ToString(), remedy_for(status)));
  return {};
}

StoreReader::Status StoreReader::for_each_editor(
    const std::function<void(edits::EditorId, StoredEditor&&)>& visit) const {
  bool sound = true;
  const auto status = scan(db_, prefix_of(KeyKind::editor), [&](const auto& key, const auto& value) {
    const auto id = editor_of_key(text_of(key));
    auto editor = decode_editor(text_of(key), bytes_of(value));
    sound = id && editor;
    if (sound) visit(*id, std::move(*editor));
    return sound;
  });
  if (!sound) return failure(fmt::format("the record of an editor is damaged; {}", kStoreLost));
  if (!status.ok()) return failure(fmt::format("{}; {}", status.ToString(), remedy_for(status)));
  return {};
}

StoreReader::Result<std::optional<StoredChunk>> StoreReader::chunk(ChunkKey key) const {
  const std::string name = chunk_key(key);
  rocksdb::PinnableSlice value;
  const auto status = db_.Get({}, db_.DefaultColumnFamily(), name, &value);
  if (status.IsNotFound()) return std::nullopt;
  if (!status.ok())
    return failure(fmt::format("chunk {}: {}; {}", to_string(key), status.ToString(), remedy_for(status)));
  auto chunk = decode_chunk_value(name, bytes_of(value));
  if (!chunk) return failure(fmt::format("chunk {} is damaged; {}", to_string(key), kStoreLost));
  return chunk;
}

StoreReader::Result<std::uint64_t> StoreReader::replay(const StoreMeta& meta,
                                                       const std::function<bool(LogRecord&&)>& visit) const {
  std::uint64_t position = meta.flushed;
  std::uint64_t link = meta.flushed_link;
  std::uint64_t bytes = 0;
  bool sound = true;
  const auto status = scan(db_, log_key(position + 1), [&](const auto& key, const auto& value) {
    if (position == meta.head.position) return false;
    auto records = decode_records(bytes_of(value), link);
    sound = records && records->front().position == position + 1 &&
            records->back().position == position_of_key(text_of(key));
    if (!sound) return false;
    bytes += value.size();
    for (LogRecord& record : *records) {
      sound = visit(std::move(record));
      if (!sound) return false;
      ++position;
    }
    return true;
  });
  if (!status.ok()) return failure(fmt::format("{}; {}", status.ToString(), remedy_for(status)));
  if (!sound || position != meta.head.position || link != meta.link) {
    return failure(fmt::format("entry {} of its log is damaged or lost, of {} that were acknowledged; {}",
                               std::min(position + 1, meta.head.position), meta.head.position, kStoreLost));
  }
  return bytes;
}

StoreReader::Status StoreReader::for_each_record(const StoreMeta& meta, std::uint64_t first,
                                                 const std::function<bool(LogRecord&&)>& visit) const {
  std::uint64_t position = std::max<std::uint64_t>(first, 1) - 1;
  bool any = false;
  bool sound = true;
  bool goes_on = true;
  std::uint64_t link = 0;
  const auto batch_of = [&](std::span<const std::byte> value) {
    // Only for entry 1 is the link before the first batch of a scan known.
    auto records = any ? decode_records(value, link) : decode_records_alone(value, link);
    if (any || !records || records->front().position != 1) return records;
    link = 0;
    return decode_records(value, link);
  };
  const auto status = scan(db_, log_key(position + 1), [&](const auto& key, const auto& value) {
    if (position == meta.head.position) return false;
    const auto last = position_of_key(text_of(key));
    if (!any && last && *last > meta.head.position) return false;  // all older records were dropped
    auto records = batch_of(bytes_of(value));
    sound =
        records && records->back().position == last && (!any || records->front().position == position + 1);
    if (!sound) return false;
    any = true;
    for (LogRecord& record : *records) {
      if (record.position < first) continue;
      position = record.position;
      goes_on = visit(std::move(record));
      if (!goes_on) return false;
    }
    return true;
  });
  if (!status.ok()) return failure(fmt::format("{}; {}", status.ToString(), remedy_for(status)));
  if (!sound || (any && goes_on && position != meta.head.position)) {
    return failure(fmt::format("entry {} of its log is damaged or lost; {}", position + 1, kStoreLost));
  }
  return {};
}

}  // namespace talus::store
