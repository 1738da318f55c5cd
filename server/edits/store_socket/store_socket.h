// The Unix socket in a data directory by which `talusd store` reaches the server that uses it: for a
// checkpoint of the database, for edits that restore voxels, and for land to be made before anybody comes. Of
// mode 600, and only the server's own user is answered.
//
// Threads of its own: nothing else waits for a command, whatever that does. What it is given is bounded
// before it is read.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

#include <tl/expected.hpp>

#include <talus/store/edit_database.h>
#include <talus/store/store_swap.h>

#include "chunks/pregen.h"
#include "edits/edit_log.h"
#include "edits/store_socket/socket_frames.h"
#include "runtime/log/logger.h"

namespace talus::server {

class Restorer;

/// Of a data directory.
[[nodiscard]] std::filesystem::path socket_path(const std::filesystem::path& directory);

class StoreSocket {
 public:
  /// Commands at once; each may hold a checkpoint.
  static constexpr std::size_t kMaxCommands = 4;

  /// How long a command may say nothing: before it has asked for anything, and then, while it reads what it
  /// was given.
  struct Patience {
    std::chrono::milliseconds first{std::chrono::seconds{10}};
    std::chrono::milliseconds next{std::chrono::hours{24}};
  };

  /// All outlive this.
  struct Parts {
    const store::EditDatabase& database;
    EditLog& log;
    std::function<std::optional<std::string>()> read_only;  // why no edits are taken; any thread
    RunPregen pregen;                                       // on a thread of the socket's; may be empty
    Patience patience{};
    std::uint64_t checkpoint_copies_bytes = store::kCheckpointCopiesBytes;
  };

  /// Makes the socket in `directory`, whose lock the process has, and starts its threads. An error is one
  /// line.
  [[nodiscard]] static tl::expected<std::unique_ptr<StoreSocket>, std::string> open(
      const std::filesystem::path& directory, Parts parts, Logger log);
  /// Ends all connections, and removes the socket and checkpoints.
  ~StoreSocket();
  StoreSocket(const StoreSocket&) = delete;
  StoreSocket& operator=(const StoreSocket&) = delete;

 private:
  struct Command {
    int socket = -1;
    std::uint64_t number = 0;
    std::atomic<bool> ended{false};
    std::thread thread;
    std::unique_ptr<store::EditDatabase::HeldFiles> held;  // of the thread
  };

  StoreSocket(std::filesystem::path directory, Parts parts, Logger log, int listener, int wake);
  void accept_all();
  void accept_one();
  void join_ended();
  void serve(Command& command);
  [[nodiscard]] tl::expected<void, std::string> make_checkpoint(const std::filesystem::path& path) const;
  /// Whether the connection goes on.
  [[nodiscard]] bool answer(Command& command, const SocketFrame& request, Restorer& restorer);
  [[nodiscard]] bool pregenerate(Command& command, const SocketFrame& request);

  const std::filesystem::path directory_;
  const Parts parts_;
  const Logger log_;
  const int listener_;
  const int wake_;         // an eventfd: the acceptor ends
  std::stop_source ends_;  // nobody waits for the log any more
  std::mutex mutex_;
  std::mutex pregen_;  // one at a time
  std::list<Command> commands_;
  std::uint64_t next_number_ = 1;
  std::thread acceptor_;
};

}  // namespace talus::server
