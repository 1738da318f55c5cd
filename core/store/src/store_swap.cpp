#include <talus/store/store_swap.h>

#include <fcntl.h>
#include <sys/stat.h>

#include <array>
#include <charconv>
#include <fstream>
#include <set>
#include <string_view>
#include <system_error>

#include <fmt/format.h>
#include <talus/files/file_layer.h>

namespace talus::store {
namespace {

namespace fs = std::filesystem;
using Status = tl::expected<void, std::string>;

constexpr std::array<std::string_view, 3> kParts{"acknowledged", "db", "store.toml"};
constexpr std::string_view kCheckpoint = "talus-checkpoint-";
/// Empty file in the new store's directory: any process that completes the swap deletes the old store.
constexpr std::string_view kOldGoes = "old-goes";

fs::path staging_of(const fs::path& directory) {
  return directory / "talus-staging";
}
fs::path next_of(const fs::path& directory) {
  return directory / "talus-next";
}

tl::unexpected<std::string> swap_failure(const fs::path& path, const std::error_code& code) {
  return tl::unexpected{fmt::format("{}: {}", path.string(), code.message())};
}

/// Renames atomically and syncs.
Status rename_now(const fs::path& from, const fs::path& to) {
  std::error_code code;
  fs::rename(from, to, code);
  if (code) return swap_failure(from, code);
  if (auto synced = sync_directory(to.parent_path()); !synced) return synced;
  return sync_directory(from.parent_path());
}

/// Rejects a part that is a mount point, which cannot be renamed: a swap would stop halfway.
Status check_parts_move(const fs::path& directory) {
  for (const std::string_view part : kParts) {
    const fs::path path = directory / part;
    struct statx about {};
    if (::statx(AT_FDCWD, path.c_str(), AT_SYMLINK_NOFOLLOW, 0, &about) != 0) continue;
    if ((about.stx_attributes & STATX_ATTR_MOUNT_ROOT) == 0) continue;
    return tl::unexpected{fmt::format(
        "{}: it is a mount point, so that no other store can take its place; mount the disk at {} "
        "instead",
        path.string(), directory.string())};
  }
  return {};
}

/// Returns an unused name.
fs::path place_for_old(const fs::path& directory) {
  for (int number = 1;; ++number) {
    fs::path path = directory / fmt::format("replaced-{}", number);
    std::error_code code;
    if (!fs::exists(fs::symlink_status(path, code))) return path;
  }
}

/// Each step is one rename, so that an interrupted swap can be resumed after any step.
tl::expected<fs::path, std::string> finish(const fs::path& directory) {
  const fs::path next = next_of(directory);
  const fs::path old = next / "old";
  std::error_code code;
  for (const std::string_view part : kParts) {
    const bool comes = fs::exists(next / part, code);
    if (code) return swap_failure(next / part, code);
    if (!comes) continue;
    const bool replaces = fs::exists(directory / part, code);
    if (code) return swap_failure(directory / part, code);
    if (replaces) {
      fs::create_directory(old, code);
      if (code) return swap_failure(old, code);
      if (auto moved = rename_now(directory / part, old / part); !moved) {
        return tl::unexpected{moved.error()};
      }
    }
    if (auto moved = rename_now(next / part, directory / part); !moved) return tl::unexpected{moved.error()};
  }
  fs::path kept;
  const bool has_old = fs::exists(old, code);
  if (code) return swap_failure(old, code);
  const bool goes = fs::exists(next / kOldGoes, code);
  if (code) return swap_failure(next / kOldGoes, code);
  if (has_old && goes) {  // before the mark is deleted
    fs::remove_all(old, code);
    if (code) return swap_failure(old, code);
  } else if (has_old) {
    kept = place_for_old(directory);
    if (auto moved = rename_now(old, kept); !moved) return tl::unexpected{moved.error()};
  }
  // The reason was about the previous store.
  fs::remove(directory / kRejoinName, code);
  if (code) return swap_failure(directory / kRejoinName, code);
  fs::remove_all(next, code);
  if (code) return swap_failure(next, code);
  if (auto synced = sync_directory(directory); !synced) return tl::unexpected{synced.error()};
  return kept;
}

}  // namespace

Status sync_directory(const fs::path& directory) {
  files::FileLayer& layer = files::system_files();
  const auto opened = layer.open_directory(directory);
  if (!opened) return swap_failure(directory, opened.error());
  const auto synced = layer.sync(*opened);
  layer.close(*opened);
  if (!synced) return swap_failure(directory, synced.error());
  return {};
}

Status check_space(const fs::path& directory, std::uint64_t bytes) {
  constexpr std::uint64_t kMore = std::uint64_t{64} << 20U;
  std::error_code code;
  const auto space = fs::space(directory, code);
  // An unknown amount of free space is not an error.
  const std::uint64_t needed = bytes <= UINT64_MAX - kMore ? bytes + kMore : UINT64_MAX;
  if (code || space.available >= needed) return {};
  return tl::unexpected{fmt::format("{}: the disk has {} bytes free; {} are needed", directory.string(),
                                    space.available, needed)};
}

fs::path checkpoint_path(const fs::path& directory, std::string_view name) {
  return directory / fmt::format("{}{}", kCheckpoint, name);
}

Status make_checkpoint(const fs::path& path, std::uint64_t copied_bytes,
                       const std::function<Status(const fs::path&)>& make) {
  if (auto enough = check_space(path.parent_path(), copied_bytes); !enough) return enough;
  std::error_code code;
  fs::remove_all(path, code);
  if (!code) fs::create_directory(path, code);
  if (code) return swap_failure(path, code);
  auto made = make(path / "db");
  if (!made) fs::remove_all(path, code);
  return made;
}

tl::expected<fs::path, std::string> make_staging(const fs::path& directory) {
  const fs::path staging = staging_of(directory);
  std::error_code code;
  fs::remove_all(staging, code);
  if (!code) fs::create_directory(staging, code);
  if (code) return swap_failure(staging, code);
  return staging;
}

tl::expected<fs::path, std::string> swap_in(const fs::path& directory, ReplacedStore replaced) {
  if (auto movable = check_parts_move(directory); !movable) return tl::unexpected{movable.error()};
  if (replaced == ReplacedStore::goes) {
    const fs::path mark = staging_of(directory) / kOldGoes;
    if (!std::ofstream{mark}) return swap_failure(mark, std::make_error_code(std::errc::io_error));
  }
  if (auto synced = sync_directory(staging_of(directory)); !synced) return tl::unexpected{synced.error()};
  if (auto named = rename_now(staging_of(directory), next_of(directory)); !named) {
    return tl::unexpected{named.error()};
  }
  return finish(directory);
}

bool swap_is_begun(const fs::path& directory) {
  std::error_code code;
  return fs::exists(fs::symlink_status(next_of(directory), code));
}

tl::expected<fs::path, std::string> keep_rejoined(const fs::path& directory, const fs::path& replaced) {
  constexpr std::size_t kMaxRejoinedStores = 2;
  constexpr std::string_view kRejoined = "rejoined-";
  std::set<std::uint64_t> numbers;
  std::error_code code;
  for (fs::directory_iterator at{directory, code}, end; !code && at != end; at.increment(code)) {
    const std::string name = at->path().filename().string();
    if (!name.starts_with(kRejoined)) continue;
    std::uint64_t number = 0;
    const char* const last = name.data() + name.size();
    const auto [stop, error] = std::from_chars(name.data() + kRejoined.size(), last, number);
    if (error == std::errc{} && stop == last && number < UINT64_MAX) numbers.insert(number);
  }
  if (code) return swap_failure(directory, code);
  const std::uint64_t next = numbers.empty() ? 1 : *numbers.rbegin() + 1;
  const fs::path kept = directory / fmt::format("{}{}", kRejoined, next);
  if (auto moved = rename_now(replaced, kept); !moved) return tl::unexpected{moved.error()};
  for (; numbers.size() >= kMaxRejoinedStores; numbers.erase(numbers.begin())) {
    const fs::path oldest = directory / fmt::format("{}{}", kRejoined, *numbers.begin());
    fs::remove_all(oldest, code);
    if (code) return swap_failure(oldest, code);
  }
  return kept;
}

Status tidy_up(const fs::path& directory) {
  std::error_code code;
  if (const auto next = fs::symlink_status(next_of(directory), code); fs::exists(next)) {
    if (!fs::is_directory(next)) {
      return tl::unexpected{
          fmt::format("{}: it is not a directory of talusd's own; remove it", next_of(directory).string())};
    }
    if (const auto finished = finish(directory); !finished) return tl::unexpected{finished.error()};
  }
  fs::remove_all(staging_of(directory), code);
  if (code) return swap_failure(staging_of(directory), code);
  for (fs::directory_iterator at{directory, code}, end; !code && at != end; at.increment(code)) {
    if (at->path().filename().string().starts_with(kCheckpoint)) fs::remove_all(at->path(), code);
  }
  if (code) return swap_failure(directory, code);
  return {};
}

}  // namespace talus::store
