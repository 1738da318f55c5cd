#include "commands/store/opened_store.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

#include <fmt/format.h>

#include <talus/store/id_check.h>

namespace talus::server {

tl::expected<OpenedStore, std::string> OpenedStore::open(const std::filesystem::path& data) {
  OpenedStore opened;
  auto server = StoreConnection::open(data);
  if (!server) return tl::unexpected{std::move(server.error())};
  if (*server) {
    opened.server_.emplace(**std::move(server));
    auto checkpoint = opened.server_->checkpoint();
    if (!checkpoint) return tl::unexpected{std::move(checkpoint.error())};
    opened.path_ = std::move(checkpoint->path);
    opened.read_only_ = std::move(checkpoint->read_only);
  } else {
    auto directory = store::DataDirectory::open_to_read(data);
    if (!directory) return tl::unexpected{std::move(directory.error())};
    if (!directory->has_edits()) {
      return tl::unexpected{
          fmt::format("data {}: it has no edits yet; run a talusd with it as its --data", data.string())};
    }
    opened.directory_.emplace(*std::move(directory));
    opened.path_ = data;
  }
  auto store = store::ReadOnlyStore::open(opened.path_);
  if (!store) return tl::unexpected{std::move(store.error())};
  opened.store_ = *std::move(store);
  if (const std::string& dropped = opened.store_->dropped(); !dropped.empty()) {
    fmt::print(stderr, "data {}: {}\n", data.string(), dropped);
  }
  if (!opened.server_) {
    const auto whole = store::check_whole_store(data, opened.store_->meta());
    if (!whole) return tl::unexpected{whole.error()};
  }
  return opened;
}

tl::expected<std::unique_ptr<store::ReadOnlyStore>, std::string> open_whole(
    const store::DataDirectory& directory) {
  auto store = store::ReadOnlyStore::open(directory.path());
  if (!store) return store;
  if (const auto whole = store::check_whole_store(directory.path(), (*store)->meta()); !whole) {
    return tl::unexpected{whole.error()};
  }
  return store;
}

tl::expected<void, std::string> check_may_write(const std::filesystem::path& data) {
  const auto server = StoreConnection::open(data);
  if (!server) return tl::unexpected{server.error()};
  if (*server) {
    return tl::unexpected{fmt::format("data {}: a talusd uses it; stop it first", data.string())};
  }
  struct stat about {};
  if (::stat(data.c_str(), &about) == 0 && about.st_uid != ::geteuid()) {
    return tl::unexpected{fmt::format("data {}: it belongs to user {}; run the command as that user",
                                      data.string(), user_name(about.st_uid))};
  }
  return {};
}

tl::expected<void, std::string> check_is_alone(const std::filesystem::path& data, std::string_view command) {
  const auto store = store::ReadOnlyStore::open(data);
  if (!store || (*store)->meta().stream.sequence == 0) return {};
  return tl::unexpected{
      fmt::format("data {}: the store belongs to a cluster, whose servers all have the same store; stop all "
                  "of them, take it out by talusd store leave-cluster, {} it, and begin a cluster with it by "
                  "talusd store join-cluster",
                  data.string(), command)};
}

}  // namespace talus::server
