// Answers on their way from a generator thread to those who wait.
#pragma once

#include <chrono>
#include <cstddef>
#include <span>
#include <unordered_map>
#include <vector>

#include "chunks/mailbox.h"
#include "runtime/clock.h"
#include "runtime/log/logger.h"

namespace talus::server {

/// Puts answers into their mailboxes and wakes the owners, in batches: waking a thread costs as much as
/// generating many a chunk, and on a busy core it takes the generator's place. For one thread and one piece
/// of work, whose last answers it tells when it is destroyed.
class AnswerBatcher {
 public:
  /// From one wake-up to the next: some fifty chunks. No player sees it.
  static constexpr std::chrono::microseconds kInterval{1000};

  AnswerBatcher(const Logger& log, const Clock& clock) : log_{log}, clock_{clock}, woke_{clock.now()} {}
  ~AnswerBatcher() { wake(); }
  AnswerBatcher(const AnswerBatcher&) = delete;
  AnswerBatcher& operator=(const AnswerBatcher&) = delete;

  /// A waiter for whom there is no memory goes without, which its mailbox and the log say.
  void add(std::span<const MailboxPtr> waiters, ChunkKey key, const ChunkAnswer& answer);
  /// Tells all that was added since the last time.
  void wake();

 private:
  const Logger& log_;
  const Clock& clock_;
  std::unordered_map<MailboxPtr, std::vector<Mail>> mail_;
  Clock::time_point woke_;
};

/// Puts one piece of mail into the box and wakes its owner. A failure goes into the log.
void deliver(const MailboxPtr& mailbox, Mail mail, const Logger& log);

}  // namespace talus::server
