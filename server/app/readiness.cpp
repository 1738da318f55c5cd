#include "app/readiness.h"

#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "runtime/reasons.h"

namespace talus::server {

std::string edits_trouble(const std::optional<std::string>& read_only, const std::string& disk_wait) {
  if (read_only) return fmt::format("no edits are taken: {}", *read_only);
  return disk_wait.empty() ? "" : fmt::format("edits wait: {}", disk_wait);
}

Readiness readiness_of(bool draining, const cluster::ClusterLog::State* shared, const LocalLog::State* own,
                       const MemoryBudget& memory) {
  bool ready = true;
  Reasons reasons;
  const auto refuse = [&](std::string_view why) {
    ready = false;
    reasons.add(why);
  };
  if (draining) refuse("draining");
  if (shared != nullptr && !shared->ready) refuse(shared->not_ready);
  const auto read_only = shared != nullptr ? shared->read_only
                         : own != nullptr  ? own->read_only
                                           : std::optional<std::string>{};
  // The next start would not have what the store has now.
  if (own != nullptr && own->gone) refuse(read_only.value_or(""));
  // New players would be refused. The gate reopens well below its closing level, so this does not flap.
  if (!memory.takes_connections()) {
    refuse(
        fmt::format("new connections are refused: this server's memory is all in use, {} bytes "
                    "with its caches, and limits.memory_bytes is {}",
                    memory.used(), memory.limit_bytes()));
  }
  if (!ready) {
    reasons.add(read_only.value_or(""));
    return {false, reasons.text()};
  }
  // Still ready: chunks are served without the log, and otherwise a balancer would drop all servers at once.
  const std::string disk_wait = shared != nullptr ? shared->disk_wait : own != nullptr ? own->disk_wait : "";
  if (const auto trouble = edits_trouble(read_only, disk_wait); !trouble.empty()) {
    return {true, fmt::format("ready; {}", trouble)};
  }
  if (shared != nullptr && !shared->late.empty()) {
    return {true, fmt::format("ready; other servers' edits arrive up to a second late: {}", shared->late)};
  }
  return {};
}

}  // namespace talus::server
