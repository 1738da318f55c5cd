// A checkpoint's tar, and what is made of one that is not as it should be.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include <archive.h>
#include <archive_entry.h>
#include <catch2/catch.hpp>

#include <talus/store/read_only_store.h>
#include <talus/store/whole_store.h>

#include "checkpoint_store.h"
#include "cluster/checkpoint/take_checkpoint.h"

namespace talus::server {
namespace {

using namespace testing;
namespace fs = std::filesystem;

/// Bytes at hand, in pieces of any size.
class TextSource final : public TarSource {
 public:
  explicit TextSource(std::string text, std::size_t piece = 10'000)
      : text_{std::move(text)}, announced{text_.size()}, piece_{piece} {}
  std::uint64_t size() const override { return announced; }
  tl::expected<std::string_view, std::string> read() override {
    const auto given = std::string_view{text_}.substr(at_, piece_);
    at_ += given.size();
    if (given.empty() && !ends.empty()) return tl::unexpected{ends};
    return given;
  }

 private:
  std::string text_;

 public:
  std::uint64_t announced;
  std::string ends{};  // what it fails with at its end

 private:
  std::size_t piece_;
  std::size_t at_ = 0;
};

struct TarResult {
  std::string error;
  store::StoreMeta meta;
};

/// Into a directory of its own.
TarResult take(TextSource source, const WantedStore& wanted, const fs::path& staging) {
  fs::remove_all(staging);
  fs::create_directory(staging);
  const auto meta = take_checkpoint(source, staging, wanted, [](std::uint64_t) {});
  if (!meta) {
    CHECK(meta.error().find('\n') == std::string::npos);
    return {meta.error(), {}};
  }
  return {"", *meta};
}

struct TarFile {
  std::string name;
  std::string bytes;
  unsigned type = AE_IFREG;
  std::string link{};
  bool hard = false;
};

std::vector<TarFile> unpack(const std::string& tar) {
  std::vector<TarFile> files;
  archive* const reader = ::archive_read_new();
  ::archive_read_support_format_tar(reader);
  REQUIRE(::archive_read_open_memory(reader, tar.data(), tar.size()) == ARCHIVE_OK);
  archive_entry* entry = nullptr;
  while (::archive_read_next_header(reader, &entry) == ARCHIVE_OK) {
    TarFile file{::archive_entry_pathname(entry),
                 std::string(static_cast<std::size_t>(::archive_entry_size(entry)), 0)};
    REQUIRE(::archive_read_data(reader, file.bytes.data(), file.bytes.size()) ==
            static_cast<la_ssize_t>(file.bytes.size()));
    files.push_back(std::move(file));
  }
  ::archive_read_free(reader);
  return files;
}

std::string pack(const std::vector<TarFile>& files, bool pax = false) {
  std::string tar(std::size_t{4} << 20U, 0);
  std::size_t used = 0;
  archive* const writer = ::archive_write_new();
  if (pax) {
    ::archive_write_set_format_pax(writer);
  } else {
    ::archive_write_set_format_ustar(writer);
  }
  REQUIRE(::archive_write_open_memory(writer, tar.data(), tar.size(), &used) == ARCHIVE_OK);
  for (const TarFile& file : files) {
    archive_entry* const entry = ::archive_entry_new();
    ::archive_entry_set_pathname(entry, file.name.c_str());
    ::archive_entry_set_filetype(entry, file.type);
    ::archive_entry_set_perm(entry, 0644);
    ::archive_entry_set_size(entry, static_cast<la_int64_t>(file.bytes.size()));
    if (!file.link.empty() && file.hard) ::archive_entry_set_hardlink(entry, file.link.c_str());
    if (!file.link.empty() && !file.hard) ::archive_entry_set_symlink(entry, file.link.c_str());
    REQUIRE(::archive_write_header(writer, entry) == ARCHIVE_OK);
    (void)::archive_write_data(writer, file.bytes.data(), file.bytes.size());
    ::archive_entry_free(entry);
  }
  ::archive_write_close(writer);
  ::archive_write_free(writer);
  tar.resize(used);
  return tar;
}

}  // namespace

TEST_CASE("a checkpoint's tar becomes the same store, whatever pieces it comes in") {
  CheckpointStore peer;
  const std::string tar = peer.tar();
  CHECK_FALSE(fs::exists(peer.path / "talus-checkpoint-test"));  // it took it away
  for (const std::size_t piece : {std::size_t{1}, std::size_t{511}, std::size_t{1} << 20U}) {
    const TarResult taken = take(TextSource{tar, piece}, {{1, 2}, peer.id()}, peer.scratch / "staging");
    REQUIRE(taken.error == "");
    CHECK(taken.meta.head == peer.head());
    EditStore joined{peer.scratch / "staging"};
    CHECK(joined.open() == "");
    CHECK(overrides_of(joined.state()) == overrides_of(peer.store.state()));
    CHECK(joined.state().editor(peer.editor.id)->epoch == 1);
  }
}

TEST_CASE("a store of whatever time has a tar") {
  CheckpointStore peer{7, 3};
  peer.store.close();
  REQUIRE(peer.store.open_without_log() == "");
  {
    const EditState::Reader reading{peer.store.state()};
    edits::Batch batch{reading, peer.store.state().editors(), peer.store.state().head(), INT64_MAX};
    batch.apply(edits::AttachEntry{{8, 9}, 1, "of the end of time"});
    REQUIRE(peer.store.database().append(batch, {}).has_value());
  }
  const TarResult taken = take(TextSource{peer.tar()}, {{1, 2}, peer.id()}, peer.scratch / "staging");
  REQUIRE(taken.error == "");
  CHECK(taken.meta.head.time_ms == INT64_MAX);
}

TEST_CASE("a checkpoint while edits go on is of one moment") {
  CheckpointStore peer;
  std::atomic<bool> stop = false;
  std::thread edits{[&] {
    std::mt19937_64 random{3};
    while (!stop) (void)peer.editor.edit(peer.store, random_edit(random));
  }};
  for (int i = 0; i < 20; ++i) {
    const TarResult taken = take(TextSource{peer.tar()}, {{1, 2}, std::nullopt}, peer.scratch / "staging");
    CHECK(taken.error == "");
  }
  stop = true;
  edits.join();
}

TEST_CASE("a checkpoint that is given up leaves no directory") {
  CheckpointStore peer;
  {
    const auto tar = peer.checkpoint();
    REQUIRE(tar->next().has_value());
    CHECK(fs::exists(peer.path / "talus-checkpoint-test"));
  }
  CHECK_FALSE(fs::exists(peer.path / "talus-checkpoint-test"));
}

TEST_CASE("a tar that is cut, damaged, or ends with the connection is refused in one line") {
  CheckpointStore peer{7, 40};
  const std::string tar = peer.tar();
  const fs::path staging = peer.scratch / "staging";
  const WantedStore wanted{{1, 2}, peer.id()};
  // The two blocks of zeros at the end are no store's.
  for (std::size_t end = 0; end + 1024 < tar.size(); end += 509) {
    TextSource source{tar.substr(0, end)};
    source.announced = tar.size();
    INFO(end);
    CHECK(take(source, wanted, staging).error != "");
    source.ends = "http://peer: the connection ended";
    CHECK(take(source, wanted, staging).error != "");
  }
  std::size_t harmless = 0;
  std::mt19937_64 random{5};
  for (int i = 0; i < 300; ++i) {
    std::string damaged = tar;
    const std::size_t at = random() % (tar.size() - 1024);
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << random() % 8));
    const TarResult taken = take(TextSource{damaged}, wanted, staging);
    INFO(at);
    // Padding and fields of headers that say nothing of a file's bytes or name.
    if (taken.error.empty()) {
      ++harmless;
      CHECK(taken.meta.head == peer.head());
    }
  }
  CHECK(harmless < 200);
}

TEST_CASE("a file that does not belong to a store is refused before it is written") {
  CheckpointStore peer{7, 40};
  const std::vector<TarFile> files = unpack(peer.tar());
  const fs::path staging = peer.scratch / "staging";
  const auto error = [&](const std::vector<TarFile>& changed, bool pax = false) {
    const std::string said = take(TextSource{pack(changed, pax)}, {{1, 2}, peer.id()}, staging).error;
    CHECK_FALSE(fs::exists(peer.scratch / "outside"));
    return said;
  };
  REQUIRE(error(files) == "");
  REQUIRE(error(files, true) == "");
  const auto with = [&](TarFile file) {
    std::vector<TarFile> changed = files;
    changed.insert(changed.begin() + 2, std::move(file));
    return changed;
  };
  CHECK_THAT(error(with({"../outside", "x"})), Catch::Contains("a store has no file \"../outside\""));
  CHECK_THAT(error(with({"db/../../outside", "x"})), Catch::Contains("a store has no file"));
  CHECK_THAT(error(with({(peer.scratch / "outside").string(), "x"})), Catch::Contains("a store has no file"));
  CHECK_THAT(error(with({"lock", "x"})), Catch::Contains("a store has no file \"lock\""));
  CHECK_THAT(error(with({"db/..", "x"})), Catch::Contains("a store has no file"));
  CHECK_THAT(error(with({"db/one\nline", "x"})), Catch::Contains("a store has no file \"db/one\\x0aline\""));
  for (const std::string name : {"db/f1", "db/LOCK", "db/000099.ssu", "db/x.sst", "db/.log", "db/MANIFEST-",
                                 "db/OPTIONS-1.dbtmp", "db/000099.sst.sst"}) {
    CHECK_THAT(error(with({name, "x"})), Catch::Contains("a store has no file \"" + name + "\""));
  }
  CHECK_THAT(error(with({"db/000099.sst", "", AE_IFLNK, "/etc/passwd"})), Catch::Contains("is a link"));
  CHECK_THAT(error(with({"db/000099.sst", "", AE_IFREG, "store.toml", true})), Catch::Contains("is a link"));
  CHECK_THAT(error(with({"db/000099.sst", "", AE_IFDIR})), Catch::Contains("is not a checkpoint"));
  CHECK_THAT(error(with({"db/000099.sst", "", AE_IFIFO})),
             Catch::Contains("is a link, a directory or a device"));
  CHECK_THAT(error(with({"db/000099.sst", "x"})),
             Catch::Contains("\"db/000099.sst\" in it differs from its"));
  CHECK_THAT(error(with(files[3])), Catch::Contains("twice"));
  CHECK_THAT(error(with({"acknowledged", std::string(5'000, 'x')})), Catch::Contains("twice"));
  std::vector<TarFile> changed = files;
  std::swap(changed[0], changed[1]);
  CHECK_THAT(error(changed), Catch::Contains("its first file is \"acknowledged\""));
  changed = files;
  changed.pop_back();
  CHECK_THAT(error(changed), Catch::Contains("it ends before its manifest"));
  changed = files;
  changed.erase(changed.begin() + 3);
  CHECK_THAT(error(changed), Catch::Contains("differs from its manifest"));
  changed = files;
  changed.push_back({"db/000099.sst", "x"});
  CHECK_THAT(error(changed), Catch::Contains("follows its manifest"));
  changed = files;
  changed[1].bytes = std::string(5'000, 'x');
  CHECK_THAT(error(changed), Catch::Contains("\"acknowledged\" in it has 5000 bytes, more than it may"));
  CHECK_THAT(error({}), Catch::Contains("is not a checkpoint"));
  const std::string compressed{"\x1f\x8b\x08\x00\x00\x00\x00\x00\x00\x03", 10};
  CHECK_THAT(take(TextSource{compressed}, {{1, 2}, peer.id()}, staging).error,
             Catch::Contains("is not a checkpoint"));
}

TEST_CASE("a checkpoint of more files than a store of its size has is refused while it comes") {
  CheckpointStore peer{7, 40};
  std::vector<TarFile> files = unpack(peer.tar());
  for (int i = 0; i < 400; ++i)
    files.insert(files.begin() + 2, {"db/" + std::to_string(100'000 + i) + ".sst", ""});
  const fs::path staging = peer.scratch / "staging";
  CHECK_THAT(take(TextSource{pack(files)}, {{1, 2}, peer.id()}, staging).error,
             Catch::Contains("it has over 300 files, more than its size needs"));
}

TEST_CASE("no more is read than was announced, and nothing if the disk is too small") {
  CheckpointStore peer{7, 40};
  const std::string tar = peer.tar();
  TextSource small{tar};
  small.announced = 2'000;
  CHECK_THAT(take(small, {{1, 2}, peer.id()}, peer.scratch / "staging").error,
             Catch::Contains("more than it may"));
  TextSource large{tar};
  large.announced = std::uint64_t{1} << 60U;
  CHECK_THAT(take(large, {{1, 2}, peer.id()}, peer.scratch / "staging").error, Catch::Contains("bytes free"));
}

TEST_CASE("a store of another world or of another id is refused by its first file") {
  CheckpointStore peer{7, 40};
  const std::string tar = peer.tar().substr(0, 2'048);
  CHECK_THAT(take(TextSource{tar}, {{1, 3}, peer.id()}, peer.scratch / "staging").error,
             Catch::Contains("its store is of the world with fingerprint"));
  CHECK_THAT(take(TextSource{tar}, {{1, 2}, ContentHash{9, 9}}, peer.scratch / "staging").error,
             Catch::Contains("this server wants 00000000000000090000000000000009"));
}

TEST_CASE("edits that do not match the state's hash are refused, though every checksum is right") {
  CheckpointStore peer{7, 40};
  const fs::path at = peer.scratch / "checkpoint";
  fs::create_directory(at);
  REQUIRE(peer.store.database().checkpoint(at / "db").has_value());
  {
    auto settings = peer.store.database_settings;
    settings.path = at;
    auto database = store::EditDatabase::open(settings);  // without the file acknowledged: another store
    REQUIRE(database.has_value());
    REQUIRE((*database)->replay([](store::LogRecord&&) { return true; }).has_value());
    store::EditDatabase::Slice slice;
    const std::vector<Override> voxels{{7, MaterialId{3}}};
    slice.put(ChunkKey{{100, 2, 3}, Lod{}}, 1, voxels);
    REQUIRE((*database)->put(slice).has_value());
  }
  const auto tar = CheckpointTar::open(at);
  REQUIRE(tar.has_value());
  std::string all;
  for (auto piece = (*tar)->next(); !piece->empty(); piece = (*tar)->next()) all += *piece;
  CHECK_THAT(take(TextSource{all}, {{1, 2}, std::nullopt}, peer.scratch / "staging").error,
             Catch::Contains("its edits have hash"));
}

}  // namespace talus::server
