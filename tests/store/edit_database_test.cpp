// Which stores are opened, and the table of materials.
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <rocksdb/db.h>
#include <rocksdb/env.h>
#include <xxhash.h>
#include <catch2/catch.hpp>

#include <talus/store/edit_database.h>
#include <talus/store/read_only_store.h>
#include <talus/store/replayed_editors.h>
#include <talus/store/rocks.h>
#include <talus/store/store_reader.h>
#include <talus/store/whole_store.h>

#include "scratch_directory.h"

namespace talus::store {
namespace {

struct Store {
  ScratchDirectory scratch;
  EditDatabaseSettings settings{.path = scratch / "edits", .fingerprint = {1, 2}, .store_id = {3, 4}};

  [[nodiscard]] std::string open() const {
    const auto database = EditDatabase::open(settings);
    return database ? std::string{} : database.error();
  }
  /// Goes on with a copy, as a kill leaves it.
  void copy_to(const std::string& name) {
    std::filesystem::copy(settings.path, scratch / name, std::filesystem::copy_options::recursive);
    settings.path = scratch / name;
  }
  [[nodiscard]] std::filesystem::path manifest() const {
    for (const auto& entry : std::filesystem::directory_iterator{settings.path / "db"}) {
      if (entry.path().filename().string().starts_with("MANIFEST-")) return entry.path();
    }
    throw std::runtime_error{"no manifest"};
  }
};

}  // namespace

TEST_CASE("a store of another world is refused with both fingerprints") {
  Store store;
  REQUIRE(store.open() == "");
  REQUIRE(store.open() == "");
  store.settings.fingerprint = {5, 6};
  const std::string error = store.open();
  CHECK(error.find("fingerprint 00000000000000020000000000000001") != std::string::npos);
  CHECK(error.find("fingerprint 00000000000000060000000000000005") != std::string::npos);
  CHECK(error.find("give --data another directory") != std::string::npos);
  store.settings.fingerprint = {1, 2};
  store.settings.store_id = {7, 7};
  CHECK(store.open().find("belong to store 00000000000000040000000000000003") != std::string::npos);
}

TEST_CASE("a store of a newer format is refused by its number") {
  Store store;
  REQUIRE(store.open() == "");
  rocksdb::DB* db = nullptr;
  REQUIRE(rocksdb::DB::Open({}, (store.settings.path / "db").string(), &db).ok());
  REQUIRE(db->Put({}, meta_key(), std::string("\x02whatever")).ok());
  delete db;
  CHECK(store.open().find("the store has format 2; this talusd reads format 1") != std::string::npos);
}

TEST_CASE("a store that another version wrote under this format's number is not called damaged") {
  Store store;
  REQUIRE(store.open() == "");
  const auto rewrite = [&](std::size_t fields, char format) {
    rocksdb::DB* opened = nullptr;
    REQUIRE(rocksdb::DB::Open({}, (store.settings.path / "db").string(), &opened).ok());
    const std::unique_ptr<rocksdb::DB> db{opened};
    std::string value;
    REQUIRE(db->Get({}, meta_key(), &value).ok());
    value.resize(fields);
    value[0] = format;
    const std::string key = meta_key();
    const std::uint64_t sum =
        XXH3_64bits_withSeed(value.data(), value.size(), XXH3_64bits(key.data(), key.size()));
    for (int byte = 0; byte < 8; ++byte) value += static_cast<char>(sum >> (8 * byte));
    REQUIRE(db->Put({}, key, value).ok());
  };
  // As talusd wrote it before it remembered which message it applied last.
  rewrite(kMetaBytes - 16, 1);
  const std::string length =
      "with format 1 and 133 bytes; this talusd reads format 1 with 141; run the talusd";
  CHECK_THAT(store.open(), Catch::Contains("another version of talusd wrote the store") &&
                               Catch::Contains(length) && !Catch::Contains("damaged"));
  const auto read = ReadOnlyStore::open(store.settings.path);
  REQUIRE_FALSE(read.has_value());
  CHECK_THAT(read.error(), Catch::Contains(length) && !Catch::Contains("damaged"));
  const auto compacted = compact(store.settings.path);
  REQUIRE_FALSE(compacted.has_value());
  CHECK_THAT(compacted.error(), Catch::Contains(length));
  rewrite(kMetaBytes - 16, 0);
  CHECK_THAT(store.open(), Catch::Contains("with format 0 and 133 bytes"));
}

TEST_CASE("a database without the store's state is refused") {
  Store store;
  REQUIRE(store.open() == "");
  rocksdb::DB* db = nullptr;
  REQUIRE(rocksdb::DB::Open({}, (store.settings.path / "db").string(), &db).ok());
  REQUIRE(db->Delete({}, meta_key()).ok());
  delete db;
  CHECK(store.open().find("its record of the store's state is missing") != std::string::npos);
}

TEST_CASE("pipes, devices and links among a store's files are refused by name, without waiting") {
  Store store;
  REQUIRE(store.open() == "");
  const auto path = store.settings.path;
  const auto put = [&](const std::filesystem::path& file, const std::string& what) {
    std::filesystem::remove(file);
    if (what == "a pipe") {
      REQUIRE(::mkfifo(file.c_str(), 0600) == 0);
    } else if (what == "a directory") {
      std::filesystem::create_directory(file);
    } else {
      std::filesystem::create_symlink("/dev/zero", file);
    }
  };
  for (const std::string what : {"a pipe", "a link", "a directory"}) {
    for (const char* const name : {"db/CURRENT", "db/000099.log", "db/000099.sst"}) {
      CAPTURE(what, name);
      const auto file = path / name;
      const auto kept = path / "kept";
      if (std::filesystem::exists(file)) std::filesystem::rename(file, kept);
      put(file, what);
      const std::string refusal = file.string() + ": it is " + what + ", and must be a regular file";
      CHECK_THAT(store.open(), Catch::Contains(refusal));
      const auto read = ReadOnlyStore::open(path);
      REQUIRE_FALSE(read.has_value());
      CHECK_THAT(read.error(), Catch::Contains(refusal));
      const auto compacted = compact(path);
      REQUIRE_FALSE(compacted.has_value());
      CHECK_THAT(compacted.error(), Catch::Contains(refusal));
      std::filesystem::remove(file);
      if (std::filesystem::exists(kept)) std::filesystem::rename(kept, file);
    }
    put(path / "acknowledged.new", what);
    if (what != "a directory") CHECK(store.open() == "");
    std::filesystem::remove(path / "acknowledged.new");
    const auto acknowledged = path / "acknowledged";
    std::filesystem::rename(acknowledged, path / "kept");
    put(acknowledged, what);
    CHECK_THAT(store.open(), Catch::Contains(acknowledged.string() + ": it is " + what));
    std::filesystem::remove(acknowledged);
    std::filesystem::rename(path / "kept", acknowledged);
  }
  std::filesystem::rename(path / "db", path / "elsewhere");
  std::filesystem::create_directory_symlink("elsewhere", path / "db");
  CHECK_THAT(store.open(), Catch::Contains("db: it is a link, and must be a directory"));
}

TEST_CASE("names of materials are bound to ids for ever") {
  Store store;
  {
    const auto database = EditDatabase::open(store.settings).value().release();
    const std::unique_ptr<EditDatabase> owner{database};
    CHECK(database->bind({{"stone", MaterialId{1}}, {"planks", MaterialId{300}}}).has_value());
    CHECK(database->bind({{"glass", MaterialId{301}}, {"stone", MaterialId{1}}}).has_value());
    const auto moved = database->bind({{"lamp", MaterialId{302}}, {"planks", MaterialId{301}}});
    REQUIRE_FALSE(moved.has_value());
    CHECK(moved.error().find("material planks has id 300 in the store and 301 here") != std::string::npos);
    const auto taken = database->bind({{"lamp", MaterialId{301}}});
    REQUIRE_FALSE(taken.has_value());
    CHECK(taken.error().find("material id 301 is glass in the store and lamp here") != std::string::npos);
  }
  const auto database = EditDatabase::open(store.settings);
  REQUIRE(database.has_value());
  CHECK((*database)->materials() == std::map<std::string, MaterialId>{{"glass", MaterialId{301}},
                                                                      {"planks", MaterialId{300}},
                                                                      {"stone", MaterialId{1}}});
}

TEST_CASE("names of generated materials follow the world, and may not be names of placed ones") {
  Store store;
  const auto database = EditDatabase::open(store.settings).value().release();
  const std::unique_ptr<EditDatabase> owner{database};
  CHECK(database->bind({{"planks", MaterialId{300}}}).has_value());
  CHECK(database->name_generated({{"stone", MaterialId{2}}, {"mud", MaterialId{3}}}).has_value());
  CHECK(database->name_generated({{"granite", MaterialId{2}}, {"stone", MaterialId{3}}}).has_value());
  const std::map<std::string, MaterialId> names{
      {"granite", MaterialId{2}}, {"planks", MaterialId{300}}, {"stone", MaterialId{3}}};
  CHECK(database->materials() == names);
  const auto refused = database->name_generated({{"planks", MaterialId{2}}});
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().find("material planks is placeable in the store, with id 300") != std::string::npos);
  CHECK(owner->settle().has_value());
}

TEST_CASE("a scan of the log begins and ends at any entry, also within a batch") {
  Store store;
  const auto database = EditDatabase::open(store.settings);
  REQUIRE(database.has_value());
  struct Nothing final : edits::OverrideSource {
    const edits::ChunkOverrides* find(ChunkKey) const override { return nullptr; }
  } const nothing;
  const edits::Editors nobody;
  edits::Head head;
  std::uint64_t epoch = 0;
  for (const int entries : {1, 3, 2}) {
    edits::Batch batch{nothing, nobody, head, 1};
    for (int i = 0; i < entries; ++i) batch.apply(edits::AttachEntry{{++epoch, 1}, 1, "somebody"});
    REQUIRE((*database)->append(batch).has_value());
    head = batch.head();
  }
  const auto read = [&](std::uint64_t first, std::uint64_t last) {
    std::vector<std::uint64_t> positions;
    const auto scanned = (*database)->for_each_record(first, [&](const LogRecord& record) {
      positions.push_back(record.position);
      CHECK(record.editor.low == record.position);
      return record.position < last;
    });
    CHECK(scanned.has_value());
    return positions;
  };
  for (std::uint64_t first = 1; first <= 6; ++first) {
    for (std::uint64_t last = first; last <= 6; ++last) {
      std::vector<std::uint64_t> all(last - first + 1);
      std::iota(all.begin(), all.end(), first);
      CHECK(read(first, last) == all);
    }
  }
  CHECK(read(0, 6).size() == 6);
  CHECK(read(7, 9).empty());
}

TEST_CASE("a checkpoint is a store of its own, and the first goes on") {
  Store store;
  const auto database = EditDatabase::open(store.settings);
  REQUIRE(database.has_value());
  CHECK((*database)->bind({{"planks", MaterialId{300}}}).has_value());
  std::filesystem::create_directory(store.scratch / "copy");
  REQUIRE((*database)->checkpoint(store.scratch / "copy" / "db").has_value());
  CHECK((*database)->bind({{"glass", MaterialId{301}}}).has_value());
  const auto copy = ReadOnlyStore::open(store.scratch / "copy");
  REQUIRE(copy.has_value());
  CHECK((*copy)->materials() == std::map<std::string, MaterialId>{{"planks", MaterialId{300}}});
  CHECK((*copy)->meta() == (*database)->meta());
  // A name that is taken is an error, and leaves what is there.
  CHECK_FALSE((*database)->checkpoint(store.scratch / "copy" / "db").has_value());
  CHECK(ReadOnlyStore::open(store.scratch / "copy").has_value());
}

TEST_CASE("a damaged end of the manifest is dropped only if the log has all that it named") {
  namespace fs = std::filesystem;
  const int offset = GENERATE(5, 8);  // the record's length, its content
  Store store;
  const fs::path db = store.settings.path / "db";
  fs::path log;
  std::string manifest;
  std::uintmax_t before = 0;
  {
    const auto database = EditDatabase::open(store.settings);
    REQUIRE(database.has_value());
    REQUIRE((*database)->bind({{"planks", MaterialId{300}}}).has_value());
    REQUIRE((*database)->settle().has_value());
    REQUIRE((*database)->bind({{"glass", MaterialId{301}}}).has_value());
    for (const auto& entry : fs::directory_iterator{db}) {
      if (entry.path().extension() == ".log" && entry.path() > log) log = entry.path();
      if (entry.path().filename().string().starts_with("MANIFEST-")) manifest = entry.path();
    }
    before = fs::file_size(manifest);
    fs::copy_file(log, store.scratch / "log");
    REQUIRE((*database)->settle().has_value());
    REQUIRE((*database)->bind({{"lamp", MaterialId{302}}}).has_value());
  }
  REQUIRE_FALSE(fs::exists(log));
  {
    std::fstream file{manifest, std::ios::in | std::ios::out | std::ios::binary};
    file.seekp(static_cast<std::streamoff>(before) + offset);
    file.put('\xff');
  }
  const std::string named = manifest + " from byte " + std::to_string(before) + " on";
  SECTION("the log is deleted") {
    const auto read = ReadOnlyStore::open(store.settings.path);
    REQUIRE_FALSE(read.has_value());
    CHECK_THAT(read.error(), Catch::Contains(named));
    CHECK_THAT(store.open(), Catch::Contains(named));
  }
  SECTION("the log is there") {
    fs::copy_file(store.scratch / "log", log);
    const auto read = ReadOnlyStore::open(store.settings.path);
    REQUIRE(read.has_value());
    CHECK((*read)->materials().size() == 3);
    CHECK_THAT((*read)->dropped(), Catch::Contains(named));
  }
}

TEST_CASE("a torn end of the manifest is dropped if it names a log that never existed") {
  namespace fs = std::filesystem;
  Store store;
  const auto copy_to = [&](const fs::path& to) {  // as a kill leaves it
    fs::create_directory(to);
    fs::copy(store.settings.path / "db", to / "db", fs::copy_options::recursive);
    store.settings.path = to;
  };
  for (const auto& [name, to] : {std::pair{"planks", "killed"}, std::pair{"glass", "torn"}}) {
    const auto database = EditDatabase::open(store.settings);
    REQUIRE(database.has_value());
    const auto id = static_cast<MaterialId>(300 + (*database)->materials().size());
    REQUIRE((*database)->bind({{name, id}}).has_value());
    copy_to(store.scratch / to);
  }
  for (const auto& entry : fs::directory_iterator{store.settings.path / "db"}) {
    if (!entry.path().filename().string().starts_with("MANIFEST-")) continue;
    std::ofstream{entry.path(), std::ios::binary | std::ios::app} << std::string(40, 'x');
  }
  const auto read = ReadOnlyStore::open(store.settings.path);
  INFO((read ? "" : read.error()));
  REQUIRE(read.has_value());
  CHECK((*read)->materials().size() == 2);
  CHECK_THAT((*read)->dropped(), Catch::Contains("MANIFEST-"));
}

TEST_CASE("a torn end of the manifest is dropped while a start's log is empty, and not once it is deleted") {
  namespace fs = std::filesystem;
  Store store;
  const auto logs = [&] {
    std::vector<std::pair<std::string, std::uintmax_t>> found;
    for (const auto& entry : fs::directory_iterator{store.settings.path / "db"}) {
      if (entry.path().extension() == ".log") found.emplace_back(entry.path().filename(), entry.file_size());
    }
    return found;
  };
  {
    const auto database = EditDatabase::open(store.settings);
    REQUIRE(database.has_value());
    REQUIRE((*database)->bind({{"planks", MaterialId{300}}}).has_value());
    store.copy_to("killed");
  }
  const auto database = EditDatabase::open(store.settings);
  REQUIRE(database.has_value());
  const auto started = logs();
  REQUIRE(started.size() == 1);
  REQUIRE(started.front().second == 0);
  SECTION("empty") {
    store.copy_to("torn");
    std::ofstream{store.manifest(), std::ios::binary | std::ios::app} << std::string(40, 'x');
    const auto read = ReadOnlyStore::open(store.settings.path);
    INFO((read ? "" : read.error()));
    REQUIRE(read.has_value());
    CHECK((*read)->materials().size() == 1);
    CHECK_THAT((*read)->dropped(), Catch::Contains("MANIFEST-"));
    CHECK(store.open() == "");
  }
  SECTION("deleted") {
    const auto whole = fs::file_size(store.manifest());
    REQUIRE((*database)->bind({{"glass", MaterialId{301}}}).has_value());
    REQUIRE((*database)->settle().has_value());
    store.copy_to("torn");
    REQUIRE(logs().size() == 1);
    REQUIRE(logs().front().second == 0);
    REQUIRE(logs() != started);
    fs::resize_file(store.manifest(), whole + 10);
    CHECK_THAT(store.open(), Catch::Contains("the log lacks data"));
    CHECK_FALSE(ReadOnlyStore::open(store.settings.path).has_value());
  }
}

TEST_CASE("a torn end of the manifest is dropped after a compaction that forgot sequence numbers") {
  Store store;
  for (const auto& [name, id] : {std::pair{"planks", MaterialId{300}}, std::pair{"glass", MaterialId{301}}}) {
    const auto database = EditDatabase::open(store.settings);
    REQUIRE(database.has_value());
    REQUIRE((*database)->bind({{name, id}}).has_value());
    REQUIRE((*database)->settle().has_value());
  }
  {
    rocksdb::DB* opened = nullptr;
    REQUIRE(rocksdb::DB::Open({}, store.settings.path / "db", &opened).ok());
    const std::unique_ptr<rocksdb::DB> db{opened};
    rocksdb::CompactRangeOptions all;
    all.bottommost_level_compaction = rocksdb::BottommostLevelCompaction::kForce;
    REQUIRE(db->CompactRange(all, nullptr, nullptr).ok());
    std::vector<rocksdb::LiveFileMetaData> tables;
    db->GetLiveFilesMetaData(&tables);
    REQUIRE(tables.size() == 1);
    REQUIRE(tables.front().largest_seqno == 0);
  }
  {
    const auto database = EditDatabase::open(store.settings);
    REQUIRE(database.has_value());
    REQUIRE((*database)->bind({{"lamp", MaterialId{302}}}).has_value());
    store.copy_to("torn");
  }
  std::ofstream{store.manifest(), std::ios::binary | std::ios::app} << std::string(40, 'x');
  const auto read = ReadOnlyStore::open(store.settings.path);
  INFO((read ? "" : read.error()));
  REQUIRE(read.has_value());
  CHECK((*read)->materials().size() == 3);
  CHECK_THAT((*read)->dropped(), Catch::Contains("MANIFEST-"));
}

TEST_CASE("a replayed record forgets no editor that was stored after it") {
  ReplayedEditors editors;
  const edits::EditorId stored{1, 1};
  StoredEditor later;
  later.position = 5;
  later.editor.used_ms = 1;  // by then the log's time had fallen
  editors.start(stored, std::move(later));
  LogRecord attach;
  attach.kind = edits::EntryResult::Kind::attached;
  attach.editor = {2, 2};
  attach.position = 3;
  attach.time_ms = 1 + edits::kEditorIdleMs;
  editors.apply(attach);
  CHECK_FALSE(editors.take_dirty().contains(stored));
  CHECK(editors.take().find(stored) != nullptr);
}

TEST_CASE("RocksDB's memory is reported, and bounded by the settings however much is written") {
  Store store;
  store.settings.memory = {std::size_t{128} << 10U, std::size_t{128} << 10U};
  const auto database = EditDatabase::open(store.settings);
  REQUIRE(database.has_value());
  // Of no use to a compressor.
  std::vector<Override> voxels;
  for (std::uint32_t index = 0; index < 16'384; ++index) {
    voxels.push_back({static_cast<std::uint16_t>(index * 2), MaterialId{static_cast<std::uint16_t>(index)}});
  }
  std::size_t most = 0;
  std::uint64_t written = 0;
  for (std::int32_t x = 0; x < 200; ++x) {
    EditDatabase::Slice slice;
    slice.put({{x, 0, 0}, Lod{}}, 1, voxels);
    written += slice.bytes();
    REQUIRE((*database)->put(slice).has_value());
    REQUIRE((*database)->chunk({{x / 2, 0, 0}, Lod{}}).has_value());
    most = std::max(most, (*database)->memory_bytes());
  }
  REQUIRE(written > 5'000'000);
  CHECK(most >= std::size_t{64} << 10U);
  // What is written at once, and the tables' indices, come on top.
  CHECK(most <= store.settings.memory.max_bytes() + (std::size_t{1} << 20U));
}

namespace {

/// Does something where the database looks first when it is opened.
class WatchedEnv final : public rocksdb::EnvWrapper {
 public:
  WatchedEnv() : EnvWrapper{rocksdb::Env::Default()} {}
  const char* Name() const override { return "WatchedEnv"; }
  rocksdb::Status GetChildren(const std::string& path, std::vector<std::string>* names) override {
    if (const auto visit = std::exchange(on_open_, {})) visit();
    return EnvWrapper::GetChildren(path, names);
  }
  void on_open(std::function<void()> visit) { on_open_ = std::move(visit); }

 private:
  std::function<void()> on_open_;
};

}  // namespace

TEST_CASE("while the database is opened again its memory is what it was") {
  WatchedEnv env;
  Store store;
  store.settings.env = &env;
  const auto database = EditDatabase::open(store.settings);
  REQUIRE(database.has_value());
  const std::size_t before = (*database)->memory_bytes();
  REQUIRE(before > 0);
  std::optional<std::size_t> meanwhile;
  env.on_open([&] { std::thread{[&] { meanwhile = (*database)->memory_bytes(); }}.join(); });
  REQUIRE((*database)->recover().has_value());
  CHECK(meanwhile == before);
}

TEST_CASE("a file of a newer RocksDB is not taken for a damaged one") {
  for (const char* const said :
       {"Corrupt or unsupported format_version: 9 in file 000009.sst",
        "unknown checksum type 4 from footer of 000009.sst", "VersionEdit: unknown tag"}) {
    CHECK(remedy_for(rocksdb::Status::Corruption(said)).starts_with("a newer talusd"));
  }
  CHECK(remedy_for(rocksdb::Status::Corruption("block checksum mismatch")) == kStoreLost);
}

}  // namespace talus::store
