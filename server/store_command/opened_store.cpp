#include "store_command/opened_store.h"

#include <utility>

#include <fmt/format.h>

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
    auto directory = DataDirectory::open_store(data);
    if (!directory) return tl::unexpected{std::move(directory.error())};
    opened.directory_.emplace(*std::move(directory));
    opened.path_ = data;
  }
  auto store = ReadOnlyStore::open(opened.path_);
  if (!store) return tl::unexpected{std::move(store.error())};
  opened.store_ = *std::move(store);
  return opened;
}

tl::expected<void, std::string> refuse_running_server(const std::filesystem::path& data) {
  const auto server = StoreConnection::open(data);
  if (!server) return tl::unexpected{server.error()};
  if (!*server) return {};
  return tl::unexpected{fmt::format("data {}: a talusd uses it; stop it first", data.string())};
}

}  // namespace talus::server
