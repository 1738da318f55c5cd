// Handles a store that is lost to the cluster while the server runs: the server ends, and takes another
// server's store at its next start. Replacing the store under players, with all caches and sessions, would
// amount to a restart, but a less reliable one.
#pragma once

#include <atomic>
#include <filesystem>
#include <string>

#include "cluster/cluster_log.h"
#include "runtime/log/logger.h"

namespace talus::server {

/// Exit status that asks to be started again (EX_TEMPFAIL).
inline constexpr int kStartAgain = 75;

class LostStore {
 public:
  /// Without peers the store stays, because there is not another server's store to replace it.
  LostStore(std::filesystem::path directory, bool has_peers, Logger log)
      : directory_{std::move(directory)}, has_peers_{has_peers}, log_{std::move(log)} {}

  /// Callable from any thread, once. If the server is not serving yet, ends the process.
  void lose(cluster::StoreLoss how, const std::string& reason);
  /// Ends the server so that it is started again with its store. Callable from any thread, repeatedly.
  void start_again(const std::string& reason);
  /// From now on wants_end() is polled.
  void serving() { serving_ = true; }
  [[nodiscard]] bool wants_end() const { return wants_end_; }

 private:
  void end();

  const std::filesystem::path directory_;
  const bool has_peers_;
  const Logger log_;
  std::atomic<bool> serving_{false};
  std::atomic<bool> wants_end_{false};
};

}  // namespace talus::server
