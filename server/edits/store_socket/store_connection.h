// The client of the socket in a data directory.
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

/// The user's name, or its number if it has no name.
[[nodiscard]] std::string user_name(uid_t user);

class StoreConnection {
 public:
  /// nullopt if no server listens there. An error is one line.
  [[nodiscard]] static tl::expected<std::optional<StoreConnection>, std::string> open(
      const std::filesystem::path& directory);
  StoreConnection(StoreConnection&& other) noexcept;
  StoreConnection& operator=(StoreConnection&&) = delete;
  ~StoreConnection();

  struct Checkpoint {
    /// Contains the directory db; removed with the connection. The data directory itself if the disk is too
    /// full for a checkpoint: then the server may write files there, but removes none.
    std::filesystem::path path;
    std::string read_only;  // why the server refuses edits; empty if it accepts them
  };
  [[nodiscard]] tl::expected<Checkpoint, std::string> checkpoint();
  /// Restorer::restore() in the server.
  [[nodiscard]] tl::expected<Restorer::Result, EditError> restore(
      const std::vector<edits::ChunkChanges>& changes);
  /// Has the server generate land, and reports the progress until it is done; ends with the process. An error
  /// is one line.
  [[nodiscard]] tl::expected<PregenProgress, std::string> pregen(
      const PregenPlan& plan, const std::function<void(const PregenProgress&)>& report);

 private:
  StoreConnection(int socket, std::filesystem::path directory);
  /// The next frame; an error if it reports a failure, or no frame arrives.
  [[nodiscard]] tl::expected<SocketFrame, EditError> receive();
  [[nodiscard]] tl::expected<SocketFrame, EditError> ask(SocketKind kind, std::span<const std::byte> fields,
                                                         SocketKind answer);

  int socket_;
  std::filesystem::path directory_;
};

}  // namespace talus::server
