// The log of a world's edits: what it holds is the world's state, whoever wrote it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <variant>

#include <tl/expected.hpp>

#include <talus/edits/batch.h>

namespace talus::server {

using LogEntry = std::variant<edits::AttachEntry, edits::EditEntry, edits::BindEntry>;

/// About the memory that an entry takes.
[[nodiscard]] std::size_t bytes_of(const LogEntry& entry);

struct LogFailure {
  enum class Kind : std::uint8_t {
    busy,          // as many entries wait as may, or the log stops
    unwritable,    // the store cannot be written now
    index_full,    // the edit is of a chunk that was never edited, and of such there is place for no more
    unreadable,    // what people changed in a chunk that the edit is of cannot be read
    cut_off,       // the log that servers share cannot be reached now, and the entry was not given to it
    editors_full,  // it is of a new editor, and of such there is place for no more
    too_large,     // no message of that log has room for the entry
  };
  Kind kind = Kind::busy;
  std::string reason;  // one line
};

class EditLog {
 public:
  /// Called once, on the log's thread, after the entry is stored as firmly as the log stores anything, and
  /// seen by all who look at the applied state. Must not throw, nor wait. After a failure of kind unwritable
  /// it is open whether the entry comes to be in the log: whoever sends it again with the same sequence finds
  /// out. After any other it does not.
  using Done = std::function<void(const tl::expected<const edits::Applied*, LogFailure>&)>;

  virtual ~EditLog() = default;

  /// From any thread. After a failure `done` is not called, and the entry is not in the log. A log that stops
  /// calls those whose entries are decided; of the others it is open.
  [[nodiscard]] virtual tl::expected<void, LogFailure> append(LogEntry entry, Done done) = 0;

  /// False: append() refuses at once, however few entries wait.
  [[nodiscard]] virtual bool takes_entries() const { return true; }
};

}  // namespace talus::server
