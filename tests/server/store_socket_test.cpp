// The socket in a data directory: what it gives, whom it refuses, and that no peer holds it up.
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <latch>

#include <catch2/catch.hpp>

#include <talus/store/bytes.h>
#include <talus/store/read_only_store.h>

#include "commands/store/backup.h"
#include "edits/store_socket/store_connection.h"
#include "edits/store_socket/store_socket.h"
#include "edits/store_socket/unix_address.h"
#include "edits_of_tests.h"
#include "runtime/log/logger.h"
#include "scratch_directory.h"

namespace talus::server {
namespace {

using namespace testing;
namespace fs = std::filesystem;

/// A store with its log and its socket.
struct ServedStore {
  explicit ServedStore(const fs::path& path, StoreSocket::Patience patience = {},
                       std::uint64_t checkpoint_bytes = 0)
      : directory{path}, store{path} {
    store.log_settings.flush_interval = std::chrono::milliseconds{1};
    REQUIRE(store.open() == "");
    auto opened = StoreSocket::open(
        path, {store.database(), store.log(), [this] { return read_only; }, {}, patience, checkpoint_bytes},
        make_logger("off", "text"));
    INFO((opened ? "" : opened.error()));
    REQUIRE(opened.has_value());
    socket = *std::move(opened);
  }

  fs::path directory;
  EditStore store;
  std::optional<std::string> read_only;
  std::unique_ptr<StoreSocket> socket;
};

StoreConnection connected(const fs::path& directory) {
  auto connection = StoreConnection::open(directory);
  REQUIRE(connection.has_value());
  REQUIRE(connection->has_value());
  return **std::move(connection);
}

/// What `ask` is told once the server has let go of enough of those before.
template <typename Ask>
std::string once_let_in(Ask&& ask) {
  for (;;) {
    std::string said = ask();
    if (said.find("commands use this server's store already") == std::string::npos) return said;
  }
}

/// A peer that says what it likes.
class RawPeer {
 public:
  explicit RawPeer(const fs::path& directory) : socket_{::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)} {
    const auto address = UnixAddress::of(socket_path(directory));
    REQUIRE(::connect(socket_, address->address(), address->size()) == 0);
  }
  ~RawPeer() { ::close(socket_); }
  RawPeer(const RawPeer&) = delete;
  RawPeer& operator=(const RawPeer&) = delete;

  void say(const store::Bytes& bytes) const {
    REQUIRE(::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(bytes.size()));
  }
  /// Why it is refused.
  std::string refusal() const {
    const auto frame = receive_frame(socket_, std::chrono::minutes{1});
    INFO((frame ? "" : frame.error()));
    REQUIRE(frame.has_value());
    REQUIRE(frame->kind == SocketKind::failed);
    store::ByteReader in{frame->fields};
    return in.text(1'000);
  }
  [[nodiscard]] int descriptor() const { return socket_; }

 private:
  int socket_;
};

store::Bytes frame_of(std::uint32_t length, std::initializer_list<int> bytes) {
  store::Bytes frame;
  store::ByteWriter writer{frame};
  writer.fixed32(length);
  for (const int byte : bytes) writer.byte(static_cast<std::uint8_t>(byte));
  return frame;
}

}  // namespace

TEST_CASE("a checkpoint under edits is one moment of the store, and goes with its connection") {
  const ScratchDirectory scratch{ScratchDirectory::memory()};
  ServedStore served{scratch / "data"};
  CHECK((fs::status(socket_path(served.directory)).permissions() & fs::perms::all) ==
        (fs::perms::owner_read | fs::perms::owner_write));
  TestEditor editor;
  editor.attach(served.store);
  std::mt19937_64 random{1};
  std::atomic<bool> ends = false;
  std::thread edits{[&] {
    while (!ends) (void)editor.edit(served.store, random_edit(random));
  }};
  for (int i = 0; i < 20; ++i) {
    const std::uint64_t before = served.store.log().status().head.position;
    fs::path path;
    {
      StoreConnection connection = connected(served.directory);
      const auto checkpoint = connection.checkpoint();
      INFO((checkpoint ? "" : checkpoint.error()));
      REQUIRE(checkpoint.has_value());
      path = checkpoint->path;
      CHECK(checkpoint->read_only.empty());
      const auto store = store::ReadOnlyStore::open(path);
      INFO((store ? "" : store.error()));
      REQUIRE(store.has_value());
      CHECK((*store)->meta().head.position >= before);
      edits::StateHash hash;
      REQUIRE((*store)->for_each_base_chunk([&](ChunkCoord chunk, const store::StoredChunk& stored) {
        hash.add(chunk, stored.voxels);
        return true;
      }));
      CHECK(hash == (*store)->meta().head.hash);
    }
    while (fs::exists(path)) std::this_thread::yield();
  }
  ends = true;
  edits.join();
}

TEST_CASE("if the disk has no place for a checkpoint the files are read and backed up as they lie") {
  const ScratchDirectory scratch{ScratchDirectory::memory()};
  ServedStore served{scratch / "data", {}, UINT64_MAX};
  TestEditor editor;
  editor.attach(served.store);
  std::mt19937_64 random{1};
  for (int i = 0; i < 100; ++i) (void)editor.edit(served.store, random_edit(random));
  std::atomic<bool> ends = false;
  std::thread edits{[&] {
    while (!ends) (void)editor.edit(served.store, random_edit(random));
  }};
  const auto sound = [](const fs::path& path, std::uint64_t least) {
    const auto store = store::ReadOnlyStore::open(path);
    INFO((store ? "" : store.error()));
    REQUIRE(store.has_value());
    CHECK((*store)->meta().head.position >= least);
    edits::StateHash hash;
    REQUIRE((*store)->for_each_base_chunk([&](ChunkCoord chunk, const store::StoredChunk& stored) {
      hash.add(chunk, stored.voxels);
      return true;
    }));
    CHECK(hash == (*store)->meta().head.hash);
  };
  for (int i = 0; i < 10; ++i) {
    CAPTURE(i);
    const std::uint64_t before = served.store.log().status().head.position;
    StoreConnection connection = connected(served.directory);
    const auto given = connection.checkpoint();
    INFO((given ? "" : given.error()));
    REQUIRE(given.has_value());
    CHECK(given->path == served.directory);
    sound(given->path, before);
    const fs::path backup = scratch / ("backup" + std::to_string(i));
    const auto manifest = write_backup(given->path, backup);
    INFO((manifest ? "" : manifest.error()));
    REQUIRE(manifest.has_value());
    sound(backup, before);
    CHECK(store::ReadOnlyStore::open(backup).value()->meta().head == manifest->head);
    // RocksDB removes files at other times.
    if (i % 2 == 0) REQUIRE(served.store.database().settle().has_value());
  }
  ends = true;
  edits.join();
}

TEST_CASE("a peer that asks for nothing is let go of, and one that reads is waited for") {
  const ScratchDirectory scratch;
  ServedStore served{scratch / "data",
                     {.first = std::chrono::milliseconds{50}, .next = std::chrono::hours{1}}};
  StoreConnection reads = connected(served.directory);
  REQUIRE(reads.checkpoint().has_value());
  const RawPeer silent{served.directory};
  CHECK(silent.refusal().find("says nothing") != std::string::npos);
  CHECK(reads.checkpoint().has_value());
}

TEST_CASE("the server's reason for taking no edits comes with a checkpoint") {
  const ScratchDirectory scratch;
  ServedStore served{scratch / "data"};
  served.read_only = "the disk is full";
  CHECK(connected(served.directory).checkpoint()->read_only == "the disk is full");
}

TEST_CASE("voxels that are restored through the socket are an edit of the log") {
  const ScratchDirectory scratch;
  ServedStore served{scratch / "data"};
  StoreConnection connection = connected(served.directory);
  const VoxelPos at{40, 5, 3};
  const MaterialId base = edits::testing::base_at(at);
  const MaterialId other{static_cast<std::uint16_t>(to_integer(base) + 1)};
  const auto index = static_cast<std::uint16_t>(voxel_index(local_pos(at)));
  const auto first = connection.restore({{{1, 0, 0}, {{index, base, other, base}}}});
  REQUIRE(first.has_value());
  CHECK(first->changed == 1);
  CHECK(first->revision == 1);
  // It is not `base` any more.
  const auto second = connection.restore({{{1, 0, 0}, {{index, base, MaterialId{77}, base}}}});
  REQUIRE(second.has_value());
  CHECK(second->changed == 0);
  CHECK(overrides_of(served.store.state()) == std::map<VoxelPos, MaterialId>{{at, other}});
}

TEST_CASE("a server that ends does not wait for a log that does not answer") {
  /// As without a quorum: the entry is in doubt.
  class SilentLog final : public EditLog {
   public:
    tl::expected<void, EditError> append(LogEntry, Callback done) override {
      done_ = std::move(done);
      taken.count_down();
      return {};
    }
    std::latch taken{1};

   private:
    Callback done_;
  };
  const ScratchDirectory scratch{ScratchDirectory::memory()};
  EditStore store{scratch / "data"};
  REQUIRE(store.open_without_log() == "");
  SilentLog log;
  auto socket =
      StoreSocket::open(scratch / "data", {store.database(), log, [] { return std::nullopt; }, {}, {}, 0},
                        make_logger("off", "text"));
  REQUIRE(socket.has_value());
  std::string said;
  std::thread command{[&] {
    const auto restored = connected(scratch / "data")
                              .restore({{{1, 0, 0}, {{0, MaterialId{1}, MaterialId{2}, MaterialId{1}}}}});
    said = restored ? "restored" : restored.error().message;
  }};
  log.taken.wait();
  const auto begun = std::chrono::steady_clock::now();
  socket->reset();
  CHECK(std::chrono::steady_clock::now() - begun < std::chrono::seconds{20});
  command.join();
  CHECK(said.starts_with("the running server: "));
}

TEST_CASE("a socket at the end of a long path works, and so does one that a killed process left") {
  const ScratchDirectory scratch;
  const fs::path data = scratch.path() / std::string(120, 'd');
  {
    ServedStore served{data};
    CHECK(connected(data).checkpoint().has_value());
  }
  CHECK_FALSE(fs::exists(socket_path(data)));
  const auto none = StoreConnection::open(data);
  REQUIRE(none.has_value());
  CHECK_FALSE(none->has_value());
  // A name without a listener.
  const int left = ::socket(AF_UNIX, SOCK_STREAM, 0);
  const auto address = UnixAddress::of(socket_path(data));
  REQUIRE(::bind(left, address->address(), address->size()) == 0);
  ::close(left);
  const auto stale = StoreConnection::open(data);
  REQUIRE(stale.has_value());
  CHECK_FALSE(stale->has_value());
  ServedStore again{data};
  CHECK(connected(data).checkpoint().has_value());
}

TEST_CASE("a peer that sends nonsense gets the reason, and other peers continue") {
  const ScratchDirectory scratch;
  ServedStore served{scratch / "data"};
  struct Case {
    store::Bytes said;
    std::string refusal;
  };
  const std::vector<Case> cases{
      {frame_of(0xffff'ffff, {}), "at most 1048576 are taken"},
      {frame_of(1, {1}), "a frame of 1 bytes"},
      {frame_of(2, {9, 1}), "speaks version 9"},
      {frame_of(2, {kSocketVersion, 99}), "there is no request 99"},
      {frame_of(3, {kSocketVersion, 2, 200}), "has 1 to 4096 voxels"},
      {frame_of(3, {kSocketVersion, 2, 0}), "has 1 to 4096 voxels"},
      {frame_of(50, {kSocketVersion}), "a frame ends early"},
      {{std::byte{50}}, "a frame ends early"},
  };
  for (const Case& each : cases) {
    const std::string refusal = once_let_in([&] {
      const RawPeer peer{served.directory};
      peer.say(each.said);
      ::shutdown(peer.descriptor(), SHUT_WR);
      return peer.refusal();
    });
    CAPTURE(refusal, each.refusal);
    CHECK(refusal.find(each.refusal) != std::string::npos);
  }
  CHECK(once_let_in([&] {
          const auto checkpoint = connected(served.directory).checkpoint();
          return checkpoint ? std::string{} : checkpoint.error();
        }) == "");
}

TEST_CASE("peers that say nothing hold up neither others nor the end, and are few") {
  const ScratchDirectory scratch;
  ServedStore served{scratch / "data"};
  const std::array<RawPeer, 3> silent{RawPeer{served.directory}, RawPeer{served.directory},
                                      RawPeer{served.directory}};
  silent[0].say(frame_of(50, {kSocketVersion}));  // and no more of it
  StoreConnection fourth = connected(served.directory);
  CHECK(fourth.checkpoint().has_value());
  const RawPeer fifth{served.directory};
  CHECK(fifth.refusal().find("4 commands use this server's store already") != std::string::npos);
  CHECK_THAT(connected(served.directory).checkpoint().error(),
             Catch::EndsWith("4 commands use this server's store already; wait until one has ended"));
  TestEditor editor;
  editor.attach(served.store);
  std::mt19937_64 random{1};
  CHECK(editor.edit(served.store, random_edit(random)).has_value());
  served.socket.reset();
  CHECK_FALSE(fs::exists(served.directory / "talus-checkpoint-4"));
  CHECK_FALSE(fourth.checkpoint().has_value());
}

}  // namespace talus::server
