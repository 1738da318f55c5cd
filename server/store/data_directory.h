// The directory that --data names. It belongs to one world, and one server at a time uses it.
//
// Its store.toml holds the store's id, which Welcome carries, and the fingerprint of its world.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>

#include <tl/expected.hpp>

#include <talus/files/file_layer.h>
#include <talus/voxel/content_hash.h>

namespace talus::server {

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

  /// To read what is there, without a change, and with no server beside while this lives. A backup has no
  /// lock: nobody writes it. An error is one line, for people who give a program --store.
  [[nodiscard]] static tl::expected<DataDirectory, std::string> open_to_read(
      const std::filesystem::path& path, ContentHash fingerprint);

  DataDirectory(DataDirectory&& other) noexcept;
  DataDirectory& operator=(DataDirectory&&) = delete;
  ~DataDirectory();

  [[nodiscard]] ContentHash store_id() const { return store_id_; }

 private:
  DataDirectory(int lock, ContentHash store_id) : lock_{lock}, store_id_{store_id} {}

  int lock_;  // a descriptor; closing it, or the end of the process, releases the lock
  ContentHash store_id_;
};

}  // namespace talus::server
