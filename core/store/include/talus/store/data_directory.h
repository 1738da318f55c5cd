// The directory that --data names. It belongs to one world, and one server at a time uses it.
//
// Its store.toml holds the store's id, which Welcome carries, and the fingerprint of its world.
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
  /// Creates the directory for another user. A directory that exists is left as it is.
  [[nodiscard]] static tl::expected<void, std::string> make_for(const std::filesystem::path& path, uid_t user,
                                                                gid_t group);
  /// Creates the directory and its store.toml where they are missing, and locks it. An error is one line: the
  /// directory cannot be written, another server uses it, or it belongs to another world.
  [[nodiscard]] static tl::expected<DataDirectory, std::string> open(
      const std::filesystem::path& path, ContentHash fingerprint,
      files::FileLayer& layer = files::system_files());

  /// Creates the directory where it is missing, and locks it; nothing else is made. A store that is there may
  /// be damaged, and is not looked at: identity() is none.
  [[nodiscard]] static tl::expected<DataDirectory, std::string> open_any(const std::filesystem::path& path);
  /// Locks a directory that holds a store, of whichever world.
  [[nodiscard]] static tl::expected<DataDirectory, std::string> open_store(const std::filesystem::path& path);

  /// Of a server of a cluster: creates the directory where it is missing, locks it, and makes no store in it.
  /// One of another world is refused.
  [[nodiscard]] static tl::expected<DataDirectory, std::string> open_member(const std::filesystem::path& path,
                                                                            ContentHash fingerprint);
  /// Makes the store.toml of a directory that has none.
  [[nodiscard]] tl::expected<void, std::string> begin(const StoreIdentity& identity,
                                                      files::FileLayer& layer = files::system_files());
  /// After another store was put in the place of the one that was there.
  [[nodiscard]] tl::expected<void, std::string> learn_identity() { return read_identity(); }
  /// The same for who only reads: others may read at the same time, nothing is written, and the disk may be
  /// full or read-only.
  [[nodiscard]] static tl::expected<DataDirectory, std::string> open_to_read(
      const std::filesystem::path& path);

  DataDirectory(DataDirectory&& other) noexcept;
  DataDirectory& operator=(DataDirectory&&) = delete;
  ~DataDirectory();

  /// Of one that was opened to read: nobody else may read from now on, and the caller may write. An error is
  /// one line: another command reads, or the directory cannot be written.
  [[nodiscard]] tl::expected<void, std::string> lock_to_write();

  /// Whether it holds anything of a store.
  [[nodiscard]] bool has_store() const;
  /// Or of edits: a store.toml alone is what pregen leaves.
  [[nodiscard]] bool has_edits() const;
  /// Of a store that was looked at.
  [[nodiscard]] const std::optional<StoreIdentity>& identity() const { return identity_; }
  [[nodiscard]] ContentHash store_id() const { return identity_ ? identity_->store_id : ContentHash{}; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  DataDirectory(int lock, std::filesystem::path path) : lock_{lock}, path_{std::move(path)} {}
  /// Ends what another process began there, too.
  [[nodiscard]] static tl::expected<DataDirectory, std::string> lock(const std::filesystem::path& path);

  /// None where there is no store.toml.
  [[nodiscard]] tl::expected<void, std::string> read_identity();

  int lock_;  // a descriptor; closing it, or the end of the process, releases the lock; -1: none is needed
  std::filesystem::path path_;
  std::optional<StoreIdentity> identity_;
};

}  // namespace talus::store
