#include <talus/store/data_directory.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <talus/files/atomic_file.h>
#include <talus/store/regular_files.h>
#include <talus/store/store_swap.h>

namespace talus::store {
namespace {

namespace fs = std::filesystem;

tl::unexpected<std::string> system_failure(const fs::path& path, std::string_view what, int error) {
  return tl::make_unexpected(fmt::format("data {}: {}: {}; give --data a directory that talusd may write",
                                         path.string(), what, std::generic_category().message(error)));
}

/// True for a dangling link too: an unreadable file may be a store.
bool has_name(const fs::path& file) {
  std::error_code error;
  return fs::symlink_status(file, error).type() != fs::file_type::not_found;
}

/// Rejects a directory of other files, with which talusd would mix its own.
tl::expected<void, std::string> check_ours(const fs::path& path) {
  std::error_code error;
  for (const char* const name :
       {"lock", "store.toml", "db", "acknowledged", "talus-next", "talus-staging", "rejoin"}) {
    if (has_name(path / name)) return {};
  }
  for (fs::directory_iterator at{path, error}, end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (name.starts_with('.') || name == "lost+found") continue;
    return tl::make_unexpected(
        fmt::format("data {}: it holds \"{}\" and no store; give --data a new directory, or an empty one",
                    path.string(), name));
  }
  return {};
}

/// Rejects a lock file that is not a regular file; does not follow links.
tl::expected<int, std::string> open_lock(const fs::path& path, int how) {
  const fs::path file = path / "lock";
  if (auto regular = check_regular_file(file); !regular) return tl::unexpected{std::move(regular.error())};
  const int lock = ::open(file.c_str(), how | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW, 0644);
  if (lock >= 0) return lock;
  return system_failure(path, "cannot open the file lock in it", errno);
}

/// Takes a lock of the kind `how`; `in_use` is the error's text if another process has it.
tl::expected<void, std::string> take_lock(int lock, int how, const fs::path& path, std::string_view in_use) {
  if (::flock(lock, how | LOCK_NB) == 0) return {};
  if (errno == EWOULDBLOCK) return tl::make_unexpected(fmt::format("data {}: {}", path.string(), in_use));
  return tl::make_unexpected(
      fmt::format("data {}: the file lock cannot be locked: {}; put the directory on a file system with "
                  "flock(), as local "
                  "disks have",
                  path.string(), std::generic_category().message(errno)));
}

tl::unexpected<std::string> no_store(const fs::path& path) {
  return tl::make_unexpected(
      fmt::format("data {}: it has no store; give --data a talusd's directory", path.string()));
}

tl::expected<void, std::string> check_directory(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) return {};
  return tl::make_unexpected(
      fmt::format("data {}: the directory does not exist; give --data a talusd's directory", path.string()));
}

tl::expected<void, std::string> check_world(const fs::path& file, ContentHash held, ContentHash fingerprint) {
  if (held == fingerprint) return {};
  return tl::make_unexpected(fmt::format(
      "{}: the store belongs to the world with fingerprint {}; this world has fingerprint {}; "
      "give --data another directory, or --world the store's world and secret.key_file its key if "
      "it has one, or carry the edits over by talusd store rebase",
      file.string(), to_string(held), to_string(fingerprint)));
}

}  // namespace

tl::expected<void, std::string> DataDirectory::make_for(const fs::path& path, uid_t user, gid_t group) {
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error).lexically_normal();
  // "/data/" is "/data".
  const fs::path leaf = absolute.has_filename() ? absolute : absolute.parent_path();
  if (fs::exists(leaf, error)) return {};
  fs::create_directories(leaf.parent_path(), error);
  if (error) return system_failure(path, "cannot create the directory", error.value());
  constexpr mode_t kOwnerAndGroup = 0750;
  if (::mkdir(leaf.c_str(), kOwnerAndGroup) != 0)
    return system_failure(path, "cannot create the directory", errno);
  // Through a descriptor, so that the directory cannot be replaced before its owner is changed.
  const int made = ::open(leaf.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  const int failed = made >= 0 && ::fchown(made, user, group) == 0 ? 0 : errno;
  if (made >= 0) ::close(made);
  if (failed != 0) return system_failure(path, "cannot change the directory's owner", failed);
  return {};
}

tl::expected<DataDirectory, std::string> DataDirectory::lock(const fs::path& path) {
  const auto lock = open_lock(path, O_RDWR | O_CREAT);
  if (!lock) return tl::unexpected{lock.error()};
  DataDirectory directory{*lock, path};
  constexpr std::string_view kInUse = "another talusd uses it; give --data another directory";
  if (auto taken = take_lock(*lock, LOCK_EX, path, kInUse); !taken) return tl::unexpected{taken.error()};
  if (const auto tidied = tidy_up(path); !tidied) {
    return tl::make_unexpected(fmt::format("data {}", tidied.error()));
  }
  return directory;
}

tl::expected<void, std::string> DataDirectory::read_identity() {
  const fs::path file = path_ / "store.toml";
  if (!has_name(file)) return {};
  const auto identity = read_store_identity(file);
  if (!identity) return tl::make_unexpected(identity.error());
  identity_ = *identity;
  return {};
}

tl::expected<DataDirectory, std::string> DataDirectory::open(const fs::path& path, ContentHash fingerprint,
                                                             files::FileLayer& layer) {
  auto directory = open_any(path);
  if (!directory) return directory;
  if (const auto read = directory->read_identity(); !read) return tl::make_unexpected(read.error());
  const fs::path file = path / "store.toml";
  if (directory->identity_) {
    const auto same = check_world(file, directory->identity_->fingerprint, fingerprint);
    if (!same) return tl::make_unexpected(same.error());
    return directory;
  }
  if (directory->has_edits()) {
    return tl::make_unexpected(
        fmt::format("{}: the file is missing, though the directory has a store's database; put it back, or "
                    "give --data a backup that talusd store restore made a store of",
                    file.string()));
  }
  if (const auto begun = directory->begin({random_store_id(), fingerprint}, layer); !begun) {
    return tl::make_unexpected(begun.error());
  }
  return directory;
}

tl::expected<void, std::string> DataDirectory::begin(const StoreIdentity& identity, files::FileLayer& layer) {
  if (const auto written = files::write_file(path_ / "store.toml", store_text(identity), layer); !written) {
    return system_failure(path_, "cannot write store.toml", written.error().code.value());
  }
  identity_ = identity;
  return {};
}

tl::expected<DataDirectory, std::string> DataDirectory::open_member(const fs::path& path,
                                                                    ContentHash fingerprint) {
  auto directory = open_any(path);
  if (!directory) return directory;
  if (const auto read = directory->read_identity(); !read) return tl::make_unexpected(read.error());
  if (!directory->identity_) return directory;
  const auto same = check_world(path / "store.toml", directory->identity_->fingerprint, fingerprint);
  if (!same) return tl::make_unexpected(same.error());
  return directory;
}

tl::expected<DataDirectory, std::string> DataDirectory::open_any(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) return system_failure(path, "cannot create the directory", error.value());
  if (const auto ours = check_ours(path); !ours) return tl::unexpected{ours.error()};
  return lock(path);
}

tl::expected<DataDirectory, std::string> DataDirectory::open_store(const fs::path& path) {
  if (const auto there = check_directory(path); !there) return tl::unexpected{there.error()};
  // Creates nothing in a directory that is not talusd's.
  if (!has_name(path / "store.toml") && !has_name(path / "talus-next")) return no_store(path);
  auto directory = lock(path);
  if (!directory) return directory;
  if (const auto read = directory->read_identity(); !read) return tl::make_unexpected(read.error());
  if (!directory->identity_) return no_store(path);
  return directory;
}

tl::expected<DataDirectory, std::string> DataDirectory::open_to_read(const fs::path& path) {
  if (const auto there = check_directory(path); !there) return tl::unexpected{there.error()};
  if (has_name(path / "talus-next")) return open_store(path);  // completes an interrupted swap first
  if (!has_name(path / "store.toml")) return no_store(path);
  // Without a lock file no talusd ever used the directory; one could start unnoticed only in this moment.
  DataDirectory directory{-1, path};
  if (has_name(path / "lock")) {
    const auto lock = open_lock(path, O_RDONLY);
    if (!lock) return tl::unexpected{lock.error()};
    directory.lock_ = *lock;
    const auto taken = take_lock(
        *lock, LOCK_SH, path, "a talusd uses it, or another command changes it; wait until that has ended");
    if (!taken) return tl::unexpected{taken.error()};
  }
  if (const auto read = directory.read_identity(); !read) return tl::make_unexpected(read.error());
  return directory;
}

tl::expected<void, std::string> DataDirectory::lock_to_write() {
  const auto lock = open_lock(path_, O_RDWR | O_CREAT);
  if (!lock) return tl::unexpected{lock.error()};
  // Releases the shared lock before taking the new one; another process may take it in between.
  if (lock_ >= 0) ::close(lock_);
  lock_ = *lock;
  return take_lock(lock_, LOCK_EX, path_,
                   "a talusd uses it, or another command reads it; wait until that has ended");
}

bool DataDirectory::has_store() const {
  return has_name(path_ / "store.toml") || has_edits();
}

bool DataDirectory::has_edits() const {
  return has_name(path_ / "db") || has_name(path_ / "acknowledged");
}

DataDirectory::DataDirectory(DataDirectory&& other) noexcept
    : lock_{std::exchange(other.lock_, -1)}, path_{std::move(other.path_)}, identity_{other.identity_} {}

DataDirectory::~DataDirectory() {
  if (lock_ >= 0) ::close(lock_);
}

}  // namespace talus::store
