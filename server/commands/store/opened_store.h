// A data directory's store, opened for a command of `talusd store`: a checkpoint made by the server that uses
// it, or the locked directory itself if no server does.
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
  /// Rejects a store that lost acknowledged edits or whose store.toml belongs to another store. Reports a
  /// torn end of its log, which is left out, on standard error.
  [[nodiscard]] static tl::expected<OpenedStore, std::string> open(const std::filesystem::path& data);

  [[nodiscard]] const store::ReadOnlyStore& store() const { return *store_; }
  /// Directory that contains db.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Connection to the server that uses the directory; null if no server does.
  [[nodiscard]] StoreConnection* server() { return server_ ? &*server_ : nullptr; }
  [[nodiscard]] const StoreConnection* server() const { return server_ ? &*server_ : nullptr; }
  /// Why the server rejects edits; empty if it accepts them or no server runs.
  [[nodiscard]] const std::string& read_only() const { return read_only_; }
  [[nodiscard]] store::StoreIdentity identity() const {
    return {store_->meta().store_id, store_->meta().fingerprint};
  }
  /// For a directory without a server, after close_files(): DataDirectory::lock_to_write().
  [[nodiscard]] tl::expected<void, std::string> lock_to_write() { return directory_->lock_to_write(); }
  /// Closes the files; keeps the lock or the connection.
  void close_files() { store_.reset(); }

 private:
  OpenedStore() = default;

  std::optional<StoreConnection> server_;
  std::optional<store::DataDirectory> directory_;
  std::filesystem::path path_;
  std::string read_only_;
  std::unique_ptr<store::ReadOnlyStore> store_;
};

/// Opens an exclusively used store, verifying that it has everything acknowledged.
[[nodiscard]] tl::expected<std::unique_ptr<store::ReadOnlyStore>, std::string> open_whole(
    const store::DataDirectory& directory);

/// For commands that write a store's files: fails if a server uses it, or if the files would belong to a
/// different user than the directory.
[[nodiscard]] tl::expected<void, std::string> check_may_write(const std::filesystem::path& data);

/// For commands that replace the store: fails if it belongs to a cluster, whose servers all share it. An
/// unreadable store may be replaced. `data` must be locked.
[[nodiscard]] tl::expected<void, std::string> check_is_alone(const std::filesystem::path& data,
                                                             std::string_view command);

}  // namespace talus::server
