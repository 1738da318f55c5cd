// Answers on their way from a generator thread to the clients that wait for them.
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
/// of work. The destructor sends the last answers.
class AnswerBatcher {
 public:
  /// Time from one wake-up to the next: about fifty chunks. Players do not notice it.
  static constexpr std::chrono::microseconds kInterval{1000};

  AnswerBatcher(const Logger& log, const Clock& clock) : log_{log}, clock_{clock}, woke_{clock.now()} {}
  ~AnswerBatcher() { wake(); }
  AnswerBatcher(const AnswerBatcher&) = delete;
  AnswerBatcher& operator=(const AnswerBatcher&) = delete;

  /// If memory is lacking for a waiter, it gets no answer; its mailbox and the log record that.
  void add(std::span<const Waiter> waiters, ChunkKey key, const ChunkAnswer& answer);
  /// Sends all answers that were added since the last call.
  void wake();

 private:
  const Logger& log_;
  const Clock& clock_;
  std::unordered_map<MailboxPtr, std::vector<Mail>> mail_;
  Clock::time_point woke_;
};

/// Puts one piece of mail into the box and wakes its owner. A failure is logged.
void deliver(const MailboxPtr& mailbox, Mail mail, const Logger& log);

}  // namespace talus::server
