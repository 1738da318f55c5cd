// The log of a world's edits. The world's state is what its entries make, whichever server wrote them.
#pragma once

#include <cstddef>
#include <functional>
#include <variant>

#include <tl/expected.hpp>

#include <talus/edits/batch.h>

#include "chunks/edit_error.h"

namespace talus::server {

using LogEntry = std::variant<edits::AttachEntry, edits::EditEntry, edits::BindEntry>;

/// Approximate memory of an entry.
[[nodiscard]] std::size_t bytes_of(const LogEntry& entry);

class EditLog {
 public:
  /// Called once, on the log's thread, after the entry is durable and visible in the applied state. Must not
  /// throw or wait. After EditErrorCode::unwritable it is unknown whether the log has the entry; sending it
  /// again with the same sequence finds out. After any other error the log does not have it.
  using Callback = std::function<void(const tl::expected<const edits::EntryResult*, EditError>&)>;

  virtual ~EditLog() = default;

  /// From any thread. After an error `done` is not called, and the entry is not in the log. On stop,
  /// callbacks run for decided entries only; the outcome of the others is unknown.
  [[nodiscard]] virtual tl::expected<void, EditError> append(LogEntry entry, Callback done) = 0;

  /// False if append() refuses every entry now, even with an empty queue.
  [[nodiscard]] virtual bool takes_entries() const { return true; }
};

}  // namespace talus::server
