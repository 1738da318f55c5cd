#include <talus/store/data_directory.h>

#include <sched.h>
#include <sys/file.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>

#include <talus/store/store_swap.h>
#include <catch2/catch.hpp>

#include "scratch_directory.h"

using namespace talus;
using namespace talus::store;

namespace {

namespace fs = std::filesystem;

int lock_error = 0;  // of every flock(), if not 0

constexpr ContentHash kWorld{1, 2};
constexpr ContentHash kOther{3, 4};

ContentHash id_of(const fs::path& path, ContentHash world = kWorld) {
  const auto directory = DataDirectory::open(path, world);
  REQUIRE(directory.has_value());
  return directory->store_id();
}

}  // namespace

// In the place of the C library's.
extern "C" int flock(int file, int how) noexcept {
  if (lock_error == 0) return static_cast<int>(::syscall(SYS_flock, file, how));
  errno = lock_error;
  return -1;
}

TEST_CASE("a new store has an id of its own and keeps it") {
  const ScratchDirectory scratch;
  const ContentHash id = id_of(scratch / "made/deep");
  CHECK(id != ContentHash{});
  CHECK(id_of(scratch / "made/deep") == id);
  CHECK(id_of(scratch / "second") != id);
}

TEST_CASE("a directory of other files is refused, and nothing is written into it") {
  const ScratchDirectory scratch;
  fs::create_directory(scratch / "lost+found");
  std::ofstream{scratch / "letter"} << "dear";
  const auto refused = DataDirectory::open(scratch.path(), kWorld);
  REQUIRE_FALSE(refused.has_value());
  CHECK_THAT(refused.error(), Catch::Contains("it holds \"letter\" and no store"));
  CHECK_FALSE(fs::exists(scratch / "lock"));
  fs::remove(scratch / "letter");
  const ContentHash id = id_of(scratch.path());
  std::ofstream{scratch / "letter"} << "dear";
  CHECK(id_of(scratch.path()) == id);
}

TEST_CASE("a store refuses another world, naming both") {
  const ScratchDirectory scratch;
  (void)id_of(scratch.path());
  const auto refused = DataDirectory::open(scratch.path(), kOther);
  REQUIRE_FALSE(refused.has_value());
  CHECK_THAT(refused.error(), Catch::Contains(to_string(kWorld)) && Catch::Contains(to_string(kOther)));
}

TEST_CASE("a store in use is refused") {
  const ScratchDirectory scratch;
  const auto first = DataDirectory::open(scratch.path(), kWorld);
  REQUIRE(first.has_value());
  CHECK_FALSE(DataDirectory::open(scratch.path(), kWorld).has_value());
}

TEST_CASE("commands open a store of any world, and never create one") {
  const ScratchDirectory scratch;
  CHECK_FALSE(DataDirectory::open_store(scratch / "none").has_value());
  CHECK_FALSE(fs::exists(scratch / "none"));
  const auto none = DataDirectory::open_store(scratch.path());
  REQUIRE_FALSE(none.has_value());
  CHECK_THAT(none.error(), Catch::Contains("it has no store"));
  CHECK_FALSE(fs::exists(scratch / "lock"));
  const ContentHash id = id_of(scratch.path());
  const auto opened = DataDirectory::open_store(scratch.path());
  REQUIRE(opened.has_value());
  CHECK(opened->identity() == StoreIdentity{id, kWorld});
  CHECK(opened->has_store());
}

TEST_CASE("a reader writes nothing, and only keeps writers out") {
  const ScratchDirectory scratch;
  CHECK_FALSE(DataDirectory::open_to_read(scratch.path()).has_value());
  const ContentHash id = id_of(scratch.path());
  fs::create_directory(scratch / "talus-checkpoint-1");  // what a writer would remove
  {
    const auto first = DataDirectory::open_to_read(scratch.path());
    const auto second = DataDirectory::open_to_read(scratch.path());
    REQUIRE(first.has_value());
    REQUIRE(second.has_value());
    CHECK(second->store_id() == id);
    CHECK_FALSE(DataDirectory::open_store(scratch.path()).has_value());
    CHECK(fs::exists(scratch / "talus-checkpoint-1"));
  }
  {
    const auto writer = DataDirectory::open_store(scratch.path());
    REQUIRE(writer.has_value());
    const auto refused = DataDirectory::open_to_read(scratch.path());
    REQUIRE_FALSE(refused.has_value());
    CHECK_THAT(refused.error(), Catch::Contains("a talusd uses it"));
  }
  fs::remove(scratch / "lock");
  CHECK(DataDirectory::open_to_read(scratch.path()).has_value());
  CHECK_FALSE(fs::exists(scratch / "lock"));
}

TEST_CASE("a reader may write once it is the only reader") {
  const ScratchDirectory scratch;
  (void)id_of(scratch.path());
  auto reader = DataDirectory::open_to_read(scratch.path());
  REQUIRE(reader.has_value());
  {
    const auto other = DataDirectory::open_to_read(scratch.path());
    REQUIRE(other.has_value());
    CHECK_THAT(reader->lock_to_write().error(), Catch::Contains("another command reads it"));
  }
  CHECK(reader->lock_to_write().has_value());
  CHECK_FALSE(DataDirectory::open_to_read(scratch.path()).has_value());
}

TEST_CASE("a lock that is a link or a pipe is refused, and nothing waits") {
  const ScratchDirectory scratch;
  (void)id_of(scratch.path());
  fs::remove(scratch / "lock");
  fs::create_symlink("elsewhere", scratch / "lock");
  for (const auto open : {&DataDirectory::open_store, &DataDirectory::open_to_read}) {
    const auto refused = open(scratch.path());
    REQUIRE_FALSE(refused.has_value());
    CHECK_THAT(refused.error(), Catch::Contains("lock: it is a link"));
  }
  CHECK_FALSE(fs::exists(scratch / "elsewhere"));
  fs::remove(scratch / "lock");
  REQUIRE(::mkfifo((scratch / "lock").c_str(), 0600) == 0);
  for (const auto open : {&DataDirectory::open_store, &DataDirectory::open_to_read}) {
    const auto refused = open(scratch.path());
    REQUIRE_FALSE(refused.has_value());
    CHECK_THAT(refused.error(), Catch::Contains("lock: it is a pipe"));
  }
}

TEST_CASE("a database without its store.toml is refused, and does not get one") {
  const ScratchDirectory scratch;
  fs::create_directory(scratch / "db");
  const auto refused = DataDirectory::open(scratch.path(), kWorld);
  REQUIRE_FALSE(refused.has_value());
  CHECK_THAT(refused.error(), Catch::Contains("store.toml: the file is missing"));
  CHECK_FALSE(fs::exists(scratch / "store.toml"));
}

TEST_CASE("a store.toml that cannot be looked at is refused, not replaced") {
  const ScratchDirectory scratch;
  std::filesystem::create_symlink("nowhere.toml", scratch / "store.toml");
  const auto refused = DataDirectory::open(scratch.path(), kWorld);
  REQUIRE_FALSE(refused.has_value());
  CHECK_THAT(refused.error(), Catch::Contains("store.toml") && Catch::Contains("No such file"));
  CHECK(std::filesystem::is_symlink(scratch / "store.toml"));
}

TEST_CASE("another program's store.toml is refused, not replaced") {
  const ScratchDirectory scratch;
  for (const char* text :
       {"", "not toml at all [", "store_id = \"12\"\nfingerprint = \"34\"\n", "store_id = 5"}) {
    std::ofstream{scratch / "store.toml"} << text;
    const auto refused = DataDirectory::open(scratch.path(), kWorld);
    REQUIRE_FALSE(refused.has_value());
    CHECK_THAT(refused.error(), Catch::Contains("store.toml"));
  }
}

TEST_CASE("a directory created for another user belongs to that user, and one that exists keeps its owner") {
  if (::geteuid() != 0) {
    WARN("only root can give a directory to another user: not tested");
    return;
  }
  const ScratchDirectory scratch;
  const auto owner_of = [](const std::filesystem::path& path) {
    struct stat about {};
    REQUIRE(::stat(path.c_str(), &about) == 0);
    return about.st_uid;
  };
  REQUIRE(DataDirectory::make_for(scratch / "a/b/", 4780, 4780).has_value());
  CHECK(owner_of(scratch / "a") == 0);
  CHECK(owner_of(scratch / "a/b") == 4780);
  REQUIRE(DataDirectory::make_for(scratch / "a", 4780, 4780).has_value());
  CHECK(owner_of(scratch / "a") == 0);
}

TEST_CASE("a file system without locks is not taken for another talusd") {
  const ScratchDirectory scratch;
  (void)id_of(scratch.path());
  lock_error = ENOLCK;
  const auto written = DataDirectory::open(scratch.path(), kWorld);
  const auto read = DataDirectory::open_to_read(scratch.path());
  lock_error = EWOULDBLOCK;
  const auto in_use = DataDirectory::open(scratch.path(), kWorld);
  lock_error = 0;
  REQUIRE_FALSE(written.has_value());
  CHECK_THAT(written.error(),
             Catch::Contains("cannot be locked: No locks available") && Catch::Contains("flock()"));
  REQUIRE_FALSE(read.has_value());
  CHECK(read.error() == written.error());
  REQUIRE_FALSE(in_use.has_value());
  CHECK_THAT(in_use.error(), Catch::Contains("another talusd uses it"));
}

TEST_CASE("a store of which a part is a mount point is not replaced halfway") {
  const ScratchDirectory scratch;
  const fs::path database = scratch / "db";
  fs::create_directory(database);
  fs::create_directories(scratch / "talus-staging/db");
  constexpr int kMayNotMount = 77;
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    if (::unshare(CLONE_NEWNS) != 0 && ::unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) ::_exit(kMayNotMount);
    if (::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
        ::mount(database.c_str(), database.c_str(), nullptr, MS_BIND, nullptr) != 0) {
      ::_exit(kMayNotMount);
    }
    const auto swapped = swap_in(scratch.path());
    const bool is_told = !swapped && swapped.error().find("mount point") != std::string::npos;
    ::_exit(is_told && !swap_is_begun(scratch.path()) ? 0 : 1);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  REQUIRE(WIFEXITED(status));
  if (WEXITSTATUS(status) == kMayNotMount) {
    WARN("this user may not mount");
  } else {
    CHECK(WEXITSTATUS(status) == 0);
  }
  CHECK(swap_in(scratch.path()).has_value());
}
