#include "store/data_directory.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <optional>
#include <random>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <talus/files/atomic_file.h>
#include <talus/files/secret_file.h>
#include <talus/toml/toml_bounds.h>
#include <toml++/toml.h>

namespace talus::server {
namespace {

namespace fs = std::filesystem;

tl::unexpected<std::string> system_failure(const fs::path& path, std::string_view what, int error) {
  return tl::make_unexpected(fmt::format("data {}: {}: {}; give --data a directory that talusd may write",
                                         path.string(), what, std::generic_category().message(error)));
}

ContentHash random_id() {
  std::random_device device;
  const auto half = [&] { return (std::uint64_t{device()} << 32) | device(); };
  return {half(), half()};
}

std::optional<ContentHash> parse_hash(const std::optional<std::string>& text) {
  constexpr std::size_t kHalfDigits = 16;
  if (!text || text->size() != 2 * kHalfDigits) return std::nullopt;
  ContentHash hash;
  for (const auto& [half, at] : {std::pair{&hash.high, std::size_t{0}}, std::pair{&hash.low, kHalfDigits}}) {
    const char* const begin = text->data() + at;
    const auto [stop, error] = std::from_chars(begin, begin + kHalfDigits, *half, 16);
    if (error != std::errc{} || stop != begin + kHalfDigits) return std::nullopt;
  }
  return hash;
}

std::string store_text(ContentHash id, ContentHash fingerprint) {
  return fmt::format(
      "# Written by talusd. Do not edit or delete files here: they belong to this store id and this world.\n"
      "store_id = \"{}\"\n"
      "fingerprint = \"{}\"\n",
      to_string(id), to_string(fingerprint));
}

struct StoreFile {
  ContentHash id;
  ContentHash fingerprint;
};

tl::expected<StoreFile, std::string> read_store_file(const fs::path& file) {
  std::optional<ContentHash> id;
  std::optional<ContentHash> held;
  const auto read = files::SecretFile::read(file, kMaxTomlBytes);
  if (!read) {
    return tl::make_unexpected(fmt::format("{}: {}; give --data a directory that talusd alone uses",
                                           file.string(), read.error().reason));
  }
  try {
    const bool sound = !find_toml_fault(read->text());
    const toml::table table = sound ? toml::parse(read->text()) : toml::table{};
    id = parse_hash(table["store_id"].value<std::string>());
    held = parse_hash(table["fingerprint"].value<std::string>());
  } catch (const toml::parse_error&) {
    // Reported below, as missing keys are: only a file that talusd wrote is right.
  }
  if (!id || !held) {
    return tl::make_unexpected(fmt::format(
        "{}: was not written by talusd; it needs store_id and fingerprint, each of 32 hexadecimal digits",
        file.string()));
  }
  return StoreFile{*id, *held};
}

/// The id of an existing store, which must be of this world. `otherwise`: what else than another --world
/// helps.
tl::expected<ContentHash, std::string> read_store(const fs::path& file, ContentHash fingerprint,
                                                  std::string_view otherwise) {
  const auto store = read_store_file(file);
  if (!store) return tl::make_unexpected(store.error());
  if (store->fingerprint != fingerprint) {
    return tl::make_unexpected(
        fmt::format("{}: the store belongs to the world with fingerprint {}; this world has fingerprint {}; "
                    "give {} another directory, or --world the store's world",
                    file.string(), to_string(store->fingerprint), to_string(fingerprint), otherwise));
  }
  return store->id;
}

tl::expected<ContentHash, std::string> read_or_make_store(const fs::path& path, ContentHash fingerprint,
                                                          files::FileLayer& layer) {
  const fs::path file = path / "store.toml";
  // Create it only where nothing has that name, not even a dangling link: a file that cannot be read may be a
  // store.
  std::error_code error;
  if (fs::symlink_status(file, error).type() != fs::file_type::not_found)
    return read_store(file, fingerprint, "--data");
  const ContentHash id = random_id();
  if (const auto written = files::write_file(file, store_text(id, fingerprint), layer); !written) {
    return system_failure(path, "cannot write store.toml", written.error().code.value());
  }
  return id;
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
  // Changed through a descriptor, so that nobody can put another directory in its place meanwhile.
  const int made = ::open(leaf.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  const int failed = made >= 0 && ::fchown(made, user, group) == 0 ? 0 : errno;
  if (made >= 0) ::close(made);
  if (failed != 0) return system_failure(path, "cannot change the directory's owner", failed);
  return {};
}

tl::expected<DataDirectory, std::string> DataDirectory::open(const fs::path& path, ContentHash fingerprint,
                                                             files::FileLayer& layer) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) return system_failure(path, "cannot create the directory", error.value());

  const int lock = ::open((path / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (lock < 0) return system_failure(path, "cannot write into it", errno);
  DataDirectory directory{lock, {}};
  if (::flock(lock, LOCK_EX | LOCK_NB) != 0) {
    return tl::make_unexpected(
        fmt::format("data {}: another talusd uses it; give --data another directory", path.string()));
  }
  auto id = read_or_make_store(path, fingerprint, layer);
  if (!id) return tl::make_unexpected(id.error());
  directory.store_id_ = *id;
  return directory;
}

tl::expected<DataDirectory, std::string> DataDirectory::open_to_read(const fs::path& path,
                                                                     ContentHash fingerprint) {
  std::error_code error;
  if (!fs::exists(path / "store.toml", error)) {
    return tl::make_unexpected(fmt::format(
        "store {}: there is no store.toml; give --store a directory that talusd was given as --data, "
        "or a backup of one",
        path.string()));
  }
  const int lock = ::open((path / "lock").c_str(), O_RDONLY | O_CLOEXEC);
  if (lock < 0 && errno != ENOENT) {
    return tl::make_unexpected(
        fmt::format("store {}: cannot open its lock: {}; run this as a user who may read it", path.string(),
                    std::generic_category().message(errno)));
  }
  DataDirectory directory{lock, {}};
  if (lock >= 0 && ::flock(lock, LOCK_SH | LOCK_NB) != 0) {
    return tl::make_unexpected(
        fmt::format("store {}: a talusd uses it; stop that, or let `talusd store backup` make a copy, and "
                    "give --store the copy",
                    path.string()));
  }
  auto id = read_store(path / "store.toml", fingerprint, "--store");
  if (!id) return tl::make_unexpected(id.error());
  directory.store_id_ = *id;
  return directory;
}

DataDirectory::DataDirectory(DataDirectory&& other) noexcept
    : lock_{std::exchange(other.lock_, -1)}, store_id_{other.store_id_} {}

DataDirectory::~DataDirectory() {
  if (lock_ >= 0) ::close(lock_);
}

}  // namespace talus::server
