// The store's bytes: what is written is read back, and anything else is refused.
#include <random>

#include <catch2/catch.hpp>

#include <talus/store/keys.h>
#include <talus/store/log_records.h>
#include <talus/store/records.h>

namespace talus::store {
namespace {

using Kind = edits::EntryResult::Kind;

LogRecord done_record() {
  LogRecord record;
  record.kind = Kind::done;
  record.editor = {1, 2};
  record.position = 300;
  record.revision = 200;
  record.time_ms = 1'700'000'000'000;
  record.result = {.sequence = 5, .revision = 200, .changed = 2, .conflict = {}};
  record.subject = "alice";
  record.changes = {
      {{-3, 0, 70'000},
       {{7, MaterialId{1}, MaterialId{2}, MaterialId{2}}, {9, MaterialId{0}, MaterialId{5}, MaterialId{1}}}}};
  return record;
}

/// As they follow each other: what is done makes a revision.
std::vector<LogRecord> batch_of_all_kinds() {
  std::vector<LogRecord> batch(4);
  batch[0].kind = Kind::attached;
  batch[0].editor = {3, 4};
  batch[0].epoch = 9;
  batch[0].subject = "somebody";
  batch[0].forgotten = edits::EditorId{5, 6};
  batch[1] = done_record();
  batch[2] = done_record();
  batch[2].kind = Kind::conflict;
  batch[2].result.conflict = 0;
  batch[2].subject.clear();
  batch[2].changes.clear();
  batch[3].kind = Kind::bound;
  batch[3].materials = {{"glass", MaterialId{256}}, {"lamp", MaterialId{300}}};
  std::uint64_t position = 299;
  for (LogRecord& record : batch) {
    record.position = position++;
    record.revision = position == 300 ? 199 : 200;
    record.time_ms = done_record().time_ms;
  }
  return batch;
}

std::string hex_of(const Bytes& bytes) {
  std::string hex;
  for (const std::byte byte : bytes) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    hex += kDigits[std::to_integer<std::size_t>(byte >> 4)];
    hex += kDigits[std::to_integer<std::size_t>(byte & std::byte{15})];
  }
  return hex;
}

/// Every bit flipped and every end cut off must be refused.
template <typename Decode>
void check_damage(const Bytes& value, const Decode& decode) {
  for (std::size_t bit = 0; bit < value.size() * 8; ++bit) {
    Bytes damaged = value;
    damaged[bit / 8] ^= static_cast<std::byte>(1U << (bit % 8));
    if (decode(damaged)) FAIL("bit " << bit << " makes no difference");
  }
  for (std::size_t size = 0; size < value.size(); ++size) {
    const Bytes cut(value.begin(), value.begin() + static_cast<std::ptrdiff_t>(size));
    if (decode(cut)) FAIL(size << " bytes are enough");
  }
}

}  // namespace

TEST_CASE("keys say what they are of, and are in order") {
  const ChunkKey west{{-5, 3, 2}, Lod::of(3)};
  const ChunkKey east{{4, -3, 2}, Lod::of(3)};
  CHECK(chunk_of_key(chunk_key(west)) == west);
  CHECK(chunk_of_key(chunk_key(east)) == east);
  CHECK(chunk_key(west) < chunk_key(east));
  CHECK(editor_of_key(editor_key({1, 2})) == edits::EditorId{1, 2});
  CHECK(position_of_key(log_key(77)) == 77);
  CHECK(log_key(255) < log_key(256));
  CHECK(material_of_key(material_key("glass")) == "glass");
  CHECK_FALSE(chunk_of_key(editor_key({1, 2})));
  CHECK_FALSE(chunk_of_key("c"));
  std::string beyond = chunk_key(west);
  beyond[1] = 7;
  CHECK_FALSE(chunk_of_key(beyond));
}

TEST_CASE("the record of the store's state is read back, and damage is seen") {
  StoreMeta meta;
  meta.fingerprint = {1, 2};
  meta.store_id = {3, 4};
  meta.head = {.position = 9, .revision = 8, .time_ms = 7, .hash = {5, 6}};
  meta.link = 10;
  meta.flushed = 4;
  meta.flushed_link = 11;
  meta.stream = {12, 1'700'000'000'000'000'013, 14, 15};
  Bytes value;
  encode(meta, value);
  CHECK(decode_meta(value) == meta);
  CHECK(value.size() == kMetaBytes);
  CHECK_FALSE(is_other_meta(value));
  check_damage(value, [](const Bytes& bytes) { return decode_meta(bytes).has_value(); });
  check_damage(value, [](const Bytes& bytes) { return is_other_meta(bytes); });
  CHECK(hex_of(value) ==
        "0101000000000000000200000000000000030000000000000004000000000000000100000009000000000000"
        "0008000000000000000700000000000000050000000000000006000000000000000a00000000000000040000"
        "00000000000b000000000000000c000000000000000d002a36fe9c97170e000000000000000f000000000000"
        "00932f418d2baf2c82");
}

TEST_CASE("chunks are read back under their own key alone") {
  const std::string key = chunk_key({{1, 2, 3}, Lod{}});
  const std::vector<Override> voxels{{4, MaterialId{1}}, {5, MaterialId{1}}, {900, MaterialId{300}}};
  Bytes value;
  encode(key, 77, voxels, value);
  CHECK(decode_chunk_value(key, value) == StoredChunk{77, voxels});
  CHECK(decode_chunk_revision(key, value) == 77);
  CHECK_FALSE(decode_chunk_value(chunk_key({{1, 2, 4}, Lod{}}), value));
  check_damage(value, [&](const Bytes& bytes) { return decode_chunk_value(key, bytes).has_value(); });
  encode(key, 78, std::span<const Override>{}, value);
  CHECK(decode_chunk_value(key, value) == StoredChunk{78, {}});
}

TEST_CASE("editors are read back with their results") {
  const std::string key = editor_key({1, 2});
  edits::Editor editor;
  editor.epoch = 3;
  editor.used_ms = 1'700'000'000'000;
  editor.subject = "somebody";
  for (std::uint64_t i = 1; i <= 70; ++i)
    editor.keep({.sequence = 2 * i, .revision = i, .changed = 1, .conflict = {}});
  editor.keep({.sequence = 200, .revision = 70, .changed = 0, .conflict = 3});
  Bytes value;
  encode(key, 55, editor, value);
  const auto read = decode_editor(key, value);
  REQUIRE(read.has_value());
  CHECK(read->position == 55);
  CHECK(read->editor == editor);
  check_damage(value, [&](const Bytes& bytes) { return decode_editor(key, bytes).has_value(); });
}

TEST_CASE("a batch of the log is read back in its chain alone") {
  const std::vector<LogRecord> batch = batch_of_all_kinds();
  Bytes value;
  const std::uint64_t link = encode(batch, 42, value);
  std::uint64_t before = 42;
  CHECK(decode_records(value, before) == batch);
  CHECK(before == link);
  CHECK_FALSE(decode_records(value, before).has_value());
  CHECK(before == link);
  std::uint64_t alone = 0;
  CHECK(decode_records_alone(value, alone) == batch);
  CHECK(alone == link);
  check_damage(value, [](const Bytes& bytes) {
    std::uint64_t right = 42;
    return decode_records(bytes, right).has_value();
  });
}

TEST_CASE("a batch with an entry that no log has is refused") {
  std::vector<LogRecord> batch{done_record()};
  const auto refused = [&] {
    Bytes value;
    encode(batch, 0, value);
    std::uint64_t link = 0;
    return !decode_records(value, link).has_value();
  };
  CHECK_FALSE(refused());
  batch[0].position = 0;  // there is none before 1
  CHECK(refused());
  batch[0] = {};
  batch[0].kind = Kind::bound;
  batch[0].position = 2;
  batch[0].materials = {{"glass", MaterialId{256}}};
  CHECK_FALSE(refused());
  batch[0].materials[0].second = MaterialId{255};  // of a material that worlds generate
  CHECK(refused());
}

TEST_CASE("the application of a batch has the bytes of its records") {
  edits::EntryResult applied;
  applied.kind = Kind::done;
  const LogRecord record = done_record();
  applied.editor = record.editor;
  applied.position = record.position;
  applied.revision = record.revision;
  applied.result = record.result;
  applied.subject = record.subject;
  applied.changes = record.changes;
  Bytes value;
  Bytes of_record;
  CHECK(encode(std::span{&applied, 1}, record.time_ms, 42, value) ==
        encode(std::span{&record, 1}, 42, of_record));
  CHECK(value == of_record);
}

TEST_CASE("a batch's bytes are as in FORMAT.md") {
  Bytes value;
  (void)encode(batch_of_all_kinds(), 42, value);
  CHECK(hex_of(value) ==
        "01ae0204c70180d095ffbc3100030000000000000004000000000000000908736f6d65626f64790105000000"
        "000000000600000000000000030100000000000000020000000000000005c801020005616c696365010500e0"
        "c508080200010207010100080202050207000101080201020207010100040100000000000000020000000000"
        "000005c801020109000000000000000000000000000000000205676c6173738002046c616d70ac02b30b6d31"
        "2f883b13");
}

TEST_CASE("changes of an edit are read back, and nothing else") {
  Bytes value;
  encode(done_record().changes, value);
  CHECK(decode_changes(value) == done_record().changes);
  for (std::size_t size = 0; size < value.size(); ++size) {
    CHECK_FALSE(decode_changes(std::span{value}.first(size)).has_value());
  }
  value.push_back(std::byte{0});
  CHECK_FALSE(decode_changes(value).has_value());
}

TEST_CASE("history and materials are read back") {
  const HistorySegment segment{.first = 5, .last = 900, .bytes = 70'000, .last_time_ms = 12};
  Bytes value;
  encode(history_key(5), segment, value);
  CHECK(decode_history(history_key(5), value) == segment);
  CHECK_FALSE(decode_history(history_key(6), value));
  encode(material_key("glass"), MaterialId{301}, value);
  CHECK(decode_material(material_key("glass"), value) == MaterialId{301});
  CHECK_FALSE(decode_material(material_key("glas"), value));
}

}  // namespace talus::store
