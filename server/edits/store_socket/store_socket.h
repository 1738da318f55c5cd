// The Unix socket in a data directory by which `talusd store` reaches the server that uses it: for a
// checkpoint of the database, for edits that restore voxels, and to generate land in advance. Mode 600; only
// the server's own user is answered.
//
// Commands run on threads of the socket, so that they delay nothing else. Input is bounded before it is read.
// Processes share the number of commands (flow_shares.h).
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
#include "limits/flows/flow_shares.h"
#include "runtime/log/logger.h"

namespace talus::server {

class Restorer;

/// Path of the socket of a data directory.
[[nodiscard]] std::filesystem::path socket_path(const std::filesystem::path& directory);

class StoreSocket {
 public:
  /// Maximum number of concurrent commands; each may hold a checkpoint. As many more may still end that have
  /// given way.
  static constexpr std::size_t kMaxCommands = 4;

  /// Maximum silence of a command: before its first request, and afterwards while it reads an answer.
  struct Patience {
    std::chrono::milliseconds first{std::chrono::seconds{10}};
    std::chrono::milliseconds next{std::chrono::hours{24}};
  };

  /// All outlive this.
  struct Parts {
    const store::EditDatabase& database;
    EditLog& log;
    std::function<std::optional<std::string>()> read_only;  // why edits are refused; any thread
    RunPregen pregen;                                       // on a thread of the socket's; may be empty
    Patience patience{};
    std::uint64_t checkpoint_copies_bytes = store::kCheckpointCopiesBytes;
  };

  /// Creates the socket in `directory`, which this process has locked, and starts its threads. An error is
  /// one line.
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
    std::optional<FlowShares::Part> place;
    std::unique_ptr<store::EditDatabase::HeldFiles> held;  // used by the thread only
  };

  StoreSocket(std::filesystem::path directory, Parts parts, Logger log, int listener, int wake);
  void accept_all();
  void accept_one();
  void join_ended();
  void serve(Command& command);
  [[nodiscard]] tl::expected<void, std::string> make_checkpoint(const std::filesystem::path& path) const;
  /// Returns false if the connection ends.
  [[nodiscard]] bool answer(Command& command, const SocketFrame& request, Restorer& restorer);
  [[nodiscard]] bool pregenerate(Command& command, const SocketFrame& request);

  const std::filesystem::path directory_;
  const Parts parts_;
  const Logger log_;
  const int listener_;
  const int wake_;         // an eventfd that ends the acceptor
  std::stop_source ends_;  // ends waits for the log
  std::mutex mutex_;
  std::mutex pregen_;                          // held by the only pregen
  FlowShares places_{Clock::duration::max()};  // Patience ends silent commands
  std::list<Command> commands_;
  std::uint64_t next_number_ = 1;
  std::thread acceptor_;
};

}  // namespace talus::server
