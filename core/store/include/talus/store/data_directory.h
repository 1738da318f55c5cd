// The directory that --data names. It belongs to one world and is used by one server at a time.
//
// Its store.toml holds the fingerprint of its world and the store's id, which Welcome carries.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include <talus/files/file_layer.h>
#include <talus/store/store_identity.h>
#include <talus/voxel/content_hash.h>

namespace talus::store {

class DataDirectory {
 public:
  /// Creates the directory for another user. Leaves an existing directory unchanged.
  [[nodiscard]] static tl::expected<void, std::string> make_for(const std::filesystem::path& path, uid_t user,
                                                                gid_t group);
  /// Creates the directory and its store.toml if they are missing, and locks it. An error is one line: the
  /// directory cannot be written, another server uses it, or it belongs to another world.
  [[nodiscard]] static tl::expected<DataDirectory, std::string> open(
      const std::filesystem::path& path, ContentHash fingerprint,
      files::FileLayer& layer = files::system_files());

  /// Creates the directory if it is missing, and locks it; creates nothing else. Does not read an existing
  /// store, which may be damaged: identity() is nullopt.
  [[nodiscard]] static tl::expected<DataDirectory, std::string> open_any(const std::filesystem::path& path);
  /// Locks a directory that holds a store, of any world.
  [[nodiscard]] static tl::expected<DataDirectory, std::string> open_store(const std::filesystem::path& path);

  /// For a server of a cluster: creates the directory if it is missing and locks it, without creating a
  /// store. Rejects a store of another world.
  [[nodiscard]] static tl::expected<DataDirectory, std::string> open_member(const std::filesystem::path& path,
                                                                            ContentHash fingerprint);
  /// Creates the store.toml of a directory that lacks one.
  [[nodiscard]] tl::expected<void, std::string> begin(const StoreIdentity& identity,
                                                      files::FileLayer& layer = files::system_files());
  /// Rereads the identity after the store was replaced.
  [[nodiscard]] tl::expected<void, std::string> learn_identity() { return read_identity(); }
  /// Like open_store(), but for reading only: several readers may share it, nothing is written, and the disk
  /// may be full or read-only.
  [[nodiscard]] static tl::expected<DataDirectory, std::string> open_to_read(
      const std::filesystem::path& path);

  DataDirectory(DataDirectory&& other) noexcept;
  DataDirectory& operator=(DataDirectory&&) = delete;
  ~DataDirectory();

  /// Upgrades the lock of open_to_read(): excludes all readers and allows the caller to write. An error is
  /// one line: another command reads, or the directory cannot be written.
  [[nodiscard]] tl::expected<void, std::string> lock_to_write();

  /// True if any part of a store exists.
  [[nodiscard]] bool has_store() const;
  /// True if edits exist; pregen leaves only a store.toml.
  [[nodiscard]] bool has_edits() const;
  /// nullopt unless a store was read.
  [[nodiscard]] const std::optional<StoreIdentity>& identity() const { return identity_; }
  [[nodiscard]] ContentHash store_id() const { return identity_ ? identity_->store_id : ContentHash{}; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  DataDirectory(int lock, std::filesystem::path path) : lock_{lock}, path_{std::move(path)} {}
  /// Locks the directory, then completes or cleans up an interrupted swap.
  [[nodiscard]] static tl::expected<DataDirectory, std::string> lock(const std::filesystem::path& path);

  /// Leaves identity_ empty if store.toml does not exist.
  [[nodiscard]] tl::expected<void, std::string> read_identity();

  int lock_;  // a descriptor; closing it or ending the process releases the lock; -1: unlocked
  std::filesystem::path path_;
  std::optional<StoreIdentity> identity_;
};

}  // namespace talus::store
