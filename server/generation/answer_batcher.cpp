#include "generation/answer_batcher.h"

#include <exception>
#include <new>
#include <utility>

namespace talus::server {
namespace {

// One client's trouble must not keep the answers from the others, nor end the thread. What failed for want of
// memory is tried again: much may be free a moment later.
template <typename Step>
void log_failure(const Logger& log, Step&& step) {
  try {
    try {
      step();
    } catch (const std::bad_alloc&) {
      step();
    }
  } catch (const std::exception& error) {
    log->error("an answer could not be delivered: {}", error.what());
  }
}

}  // namespace

void AnswerBatcher::add(const std::vector<MailboxPtr>& waiters, ChunkKey key, const ChunkAnswer& answer) {
  for (const MailboxPtr& waiter : waiters) {
    log_failure(log_, [&] { mail_[waiter].emplace_back(ChunkReady{key, answer}); });
  }
  if (!mail_.empty() && clock_.now() - woke_ >= kInterval) wake();
}

void AnswerBatcher::wake() {
  for (auto& each : mail_) {
    log_failure(log_, [&] { each.first->put(std::move(each.second)); });
    log_failure(log_, [&] { each.first->wake(); });
  }
  mail_.clear();
  woke_ = clock_.now();
}

void deliver(const MailboxPtr& mailbox, Mail mail, const Logger& log) {
  std::vector<Mail> letters;
  log_failure(log, [&] { letters.reserve(1); });
  if (letters.capacity() == 0) return;
  letters.push_back(std::move(mail));
  log_failure(log, [&] { mailbox->put(std::move(letters)); });
  log_failure(log, [&] { mailbox->wake(); });
}

}  // namespace talus::server
