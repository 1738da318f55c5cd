// The log of a world's edits: what it holds is the world's state, whoever wrote it.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <variant>

#include <tl/expected.hpp>

#include <talus/edits/batch.h>

namespace talus::server {

using LogEntry = std::variant<edits::AttachEntry, edits::EditEntry>;

/// Whether the entry comes to be in the log is open: whoever sends it again with the same sequence finds out.
struct LogFailure {
  std::string reason;
};

class EditLog {
 public:
  /// Called once, on the log's thread, after the entry is stored as firmly as the log stores anything, and
  /// seen by all who look at the applied state. Must not throw, nor wait.
  using Done = std::function<void(const tl::expected<const edits::Applied*, LogFailure>&)>;

  virtual ~EditLog() = default;

  /// From any thread. False, and `done` is not called: the log takes no entries now, as too many wait or it
  /// cannot write.
  [[nodiscard]] virtual bool append(LogEntry entry, Done done) = 0;
};

}  // namespace talus::server
