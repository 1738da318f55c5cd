// A data directory's store as a command of `talusd store` reads it: a checkpoint of the server that uses it,
// or the directory itself, locked, where none does.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include <talus/store/data_directory.h>
#include <talus/store/read_only_store.h>

#include "edits/store_socket/store_connection.h"

namespace talus::server {

class OpenedStore {
 public:
  /// Refuses a store that lost what was acknowledged, or whose store.toml is another store's.
  [[nodiscard]] static tl::expected<OpenedStore, std::string> open(const std::filesystem::path& data);

  [[nodiscard]] const store::ReadOnlyStore& store() const { return *store_; }
  /// Of the files: db is in it.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Of the server that uses the directory; null where none does.
  [[nodiscard]] StoreConnection* server() { return server_ ? &*server_ : nullptr; }
  [[nodiscard]] const StoreConnection* server() const { return server_ ? &*server_ : nullptr; }
  /// Why the server takes no edits; empty: it does, or there is none.
  [[nodiscard]] const std::string& read_only() const { return read_only_; }
  [[nodiscard]] store::StoreIdentity identity() const {
    return {store_->meta().store_id, store_->meta().fingerprint};
  }
  /// Where no server uses the directory: as DataDirectory's. The files were let go of.
  [[nodiscard]] tl::expected<void, std::string> lock_to_write() { return directory_->lock_to_write(); }
  /// Lets go of the files; the lock, or the connection, stays.
  void close_files() { store_.reset(); }

 private:
  OpenedStore() = default;

  std::optional<StoreConnection> server_;
  std::optional<store::DataDirectory> directory_;
  std::filesystem::path path_;
  std::string read_only_;
  std::unique_ptr<store::ReadOnlyStore> store_;
};

/// The store in a directory that nobody else uses, with all that was acknowledged.
[[nodiscard]] tl::expected<std::unique_ptr<store::ReadOnlyStore>, std::string> open_whole(
    const store::DataDirectory& directory);

/// For commands that write files of a store: refused where a server uses it, and where they would belong to
/// another user than the directory does.
[[nodiscard]] tl::expected<void, std::string> check_may_write(const std::filesystem::path& data);

/// For commands that make another store in the place of the one that is there: refused where that is one of a
/// cluster, whose servers all have the same. One that cannot be read is no hindrance. `data` is locked.
[[nodiscard]] tl::expected<void, std::string> check_is_alone(const std::filesystem::path& data,
                                                             std::string_view command);

}  // namespace talus::server
