#include "app/readiness.h"

#include <fmt/format.h>

namespace talus::server {

Readiness readiness_of(bool draining, const cluster::ClusterLog::State* log, const MemoryBudget& memory) {
  if (draining) return {false, "draining"};
  if (log != nullptr && !log->ready) return {false, log->not_ready};
  // New players would be refused. The gate reopens well below its closing level, so this does not flap.
  if (!memory.takes_connections()) {
    return {false, fmt::format("new connections are refused: this server's memory is all in use, {} bytes "
                               "with its caches, and limits.memory_bytes is {}",
                               memory.used(), memory.limit_bytes())};
  }
  // Still ready: chunks are served without the log, and otherwise a balancer would drop all servers at once.
  if (log != nullptr && log->read_only) {
    return {true, fmt::format("ready; no edits are taken: {}", *log->read_only)};
  }
  if (log != nullptr && !log->late.empty()) {
    return {true, fmt::format("ready; other servers' edits arrive up to a second late: {}", log->late)};
  }
  return {};
}

}  // namespace talus::server
