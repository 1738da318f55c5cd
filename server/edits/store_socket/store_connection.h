// A command's end of the socket in a data directory.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include <talus/edits/evaluate.h>

#include "chunks/pregen.h"
#include "edits/store_socket/restorer.h"
#include "edits/store_socket/socket_frames.h"

namespace talus::server {

/// As the system names it, or its number.
[[nodiscard]] std::string user_name(uid_t user);

class StoreConnection {
 public:
  /// Nothing where no server listens there. An error is one line.
  [[nodiscard]] static tl::expected<std::optional<StoreConnection>, std::string> open(
      const std::filesystem::path& directory);
  StoreConnection(StoreConnection&& other) noexcept;
  StoreConnection& operator=(StoreConnection&&) = delete;
  ~StoreConnection();

  struct Checkpoint {
    /// With the directory db; goes with the connection. The data directory itself where the disk has no place
    /// for a checkpoint: then files may be written there, but none is removed.
    std::filesystem::path path;
    std::string read_only;  // why the server takes no edits; empty: it does
  };
  [[nodiscard]] tl::expected<Checkpoint, std::string> checkpoint();
  /// As Restorer::restore(), of the server.
  [[nodiscard]] tl::expected<Restorer::Restored, Restorer::Failure> restore(
      const std::vector<edits::ChunkChanges>& changes);
  /// Has the server make land, and tells how far it is, until it has; ends where the process does. An error
  /// is one line.
  [[nodiscard]] tl::expected<PregenProgress, std::string> pregen(
      const PregenPlan& plan, const std::function<void(const PregenProgress&)>& report);

 private:
  StoreConnection(int socket, std::filesystem::path directory);
  /// What comes next; an error where it is a failure, or nothing comes.
  [[nodiscard]] tl::expected<SocketFrame, Restorer::Failure> receive();
  [[nodiscard]] tl::expected<SocketFrame, Restorer::Failure> ask(SocketKind kind,
                                                                 std::span<const std::byte> fields,
                                                                 SocketKind answer);

  int socket_;
  std::filesystem::path directory_;
};

}  // namespace talus::server
