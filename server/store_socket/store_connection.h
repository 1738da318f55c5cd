// A command's end of the socket in a data directory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include <talus/edits/evaluate.h>

#include "store_socket/restorer.h"
#include "store_socket/socket_frames.h"

namespace talus::server {

class StoreConnection {
 public:
  /// Nothing where no server listens there. An error is one line.
  [[nodiscard]] static tl::expected<std::optional<StoreConnection>, std::string> open(
      const std::filesystem::path& directory);
  StoreConnection(StoreConnection&& other) noexcept;
  StoreConnection& operator=(StoreConnection&&) = delete;
  ~StoreConnection();

  struct Checkpoint {
    std::filesystem::path path;  // with the directory db; goes with the connection
    std::string read_only;       // why the server takes no edits; empty: it does
  };
  [[nodiscard]] tl::expected<Checkpoint, std::string> checkpoint();
  /// As Restorer::restore(), of the server.
  [[nodiscard]] tl::expected<Restorer::Restored, Restorer::Failure> restore(
      const std::vector<edits::ChunkChanges>& changes);

 private:
  StoreConnection(int socket, std::filesystem::path directory);
  [[nodiscard]] tl::expected<SocketFrame, Restorer::Failure> ask(SocketKind kind,
                                                                 std::span<const std::byte> fields,
                                                                 SocketKind answer);

  int socket_;
  std::filesystem::path directory_;
};

}  // namespace talus::server
