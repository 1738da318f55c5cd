#include <talus/store/store_watch.h>

#include <cerrno>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace talus::store {
namespace {

std::optional<struct stat> identity_of(const std::filesystem::path& file) {
  struct stat about {};
  if (::stat(file.c_str(), &about) != 0) return std::nullopt;
  return about;
}

/// Only an answer that the file does not exist counts: a stat() may fail for a while.
bool is_deleted(const std::filesystem::path& file) {
  struct stat about {};
  return ::stat(file.c_str(), &about) != 0 && (errno == ENOENT || errno == ENOTDIR);
}

bool is_replaced(const std::filesystem::path& file, const struct stat& before) {
  const auto now = identity_of(file);
  return now ? now->st_dev != before.st_dev || now->st_ino != before.st_ino : is_deleted(file);
}

}  // namespace

StoreWatch::StoreWatch(std::filesystem::path path)
    : path_{std::move(path)},
      lock_{identity_of(path_ / "lock")},
      database_{identity_of(path_ / "db")},
      current_{identity_of(path_ / "db" / "CURRENT")} {}

std::optional<std::string> StoreWatch::gone() const {
  const auto say = [&](std::string_view name) {
    return fmt::format(
        "data {}: {} was deleted or replaced while this server used it, so edits would be lost; put the "
        "directory back, or restart this server with what is there",
        path_.string(), name);
  };
  if (lock_ && is_replaced(path_ / "lock", *lock_)) return say("lock");
  if (database_ && is_replaced(path_ / "db", *database_)) return say("db");
  if (current_ && is_deleted(path_ / "db" / "CURRENT")) return say("db/CURRENT");
  return std::nullopt;
}

}  // namespace talus::store
