// Answers on their way from a generator thread to those who wait.
#pragma once

#include <chrono>
#include <cstddef>
#include <unordered_set>
#include <vector>

#include "chunks/mailbox.h"
#include "clock/clock.h"
#include "log/logger.h"

namespace talus::server {

/// Puts each answer into its mailboxes at once, and wakes their owners in batches: waking a thread costs as
/// much as generating many a chunk, and on a busy core it takes the generator's place. For one thread and one
/// piece of work, which wake() ends.
class AnswerBatcher {
 public:
  /// From one wake-up to the next: about fifteen chunks. No player sees it.
  static constexpr std::chrono::microseconds kInterval{500};

  AnswerBatcher(const Logger& log, const Clock& clock) : log_{log}, clock_{clock} {}

  /// A waiter for whom there is no memory goes without, which the log says.
  void add(const std::vector<MailboxPtr>& waiters, ChunkKey key, const ChunkAnswer& answer);
  /// Wakes the owners of all that was added since the last time.
  void wake();

 private:
  const Logger& log_;
  const Clock& clock_;
  std::unordered_set<MailboxPtr> to_wake_;
  Clock::time_point woke_{};
};

/// Puts one piece of mail into the box and wakes its owner. A failure goes into the log.
void deliver(const MailboxPtr& mailbox, Mail mail, const Logger& log);

}  // namespace talus::server
