// The directory that --data names: bound to one world, used by one server at a time.
//
// store.toml in it holds the store's id, which Welcome says, and the fingerprint of its world.
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
  /// Makes the directory for another user where it is missing; one that is there already is left as it is.
  [[nodiscard]] static tl::expected<void, std::string> make_for(const std::filesystem::path& path, uid_t user,
                                                                gid_t group);
  /// Makes the directory and its store.toml where they are missing, and locks it. One line says why not:
  /// it cannot be written, another server has it, or it belongs to a world of another fingerprint.
  [[nodiscard]] static tl::expected<DataDirectory, std::string> open(
      const std::filesystem::path& path, ContentHash fingerprint,
      files::FileLayer& layer = files::system_files());

  DataDirectory(DataDirectory&& other) noexcept;
  DataDirectory& operator=(DataDirectory&&) = delete;
  ~DataDirectory();

  [[nodiscard]] ContentHash store_id() const { return store_id_; }

 private:
  DataDirectory(int lock, ContentHash store_id) : lock_{lock}, store_id_{store_id} {}

  int lock_;  // a descriptor; the lock ends with it, however the process ends
  ContentHash store_id_;
};

}  // namespace talus::server
