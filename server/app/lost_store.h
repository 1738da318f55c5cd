// A store that is lost to the cluster while the server runs: it ends, and takes another server's store when
// it is started again. To change the store under players, with all that caches and sessions have of it, would
// be to start again, but less surely.
#pragma once

#include <atomic>
#include <filesystem>
#include <string>

#include "cluster/cluster_log.h"
#include "runtime/log/logger.h"

namespace talus::server {

/// Exit status of a server that is to be started again (EX_TEMPFAIL).
inline constexpr int kStartAgain = 75;

class LostStore {
 public:
  /// Of the store in `directory`. Without peers it stays: there is nobody whose store could take its place.
  LostStore(std::filesystem::path directory, bool has_peers, Logger log)
      : directory_{std::move(directory)}, has_peers_{has_peers}, log_{std::move(log)} {}

  /// Any thread, once. Where the server does not serve yet it ends the process.
  void lose(cluster::Lost how, const std::string& reason);
  /// The store is good for a start alone. Any thread, any number of times.
  void start_again(const std::string& reason);
  /// From now on somebody asks wants_end().
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
