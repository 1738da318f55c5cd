#include "generation/answer_batcher.h"

#include <exception>
#include <utility>

namespace talus::server {
namespace {

// One client's trouble must not keep the answers from the others, nor end the thread.
template <typename Step>
void log_failure(const Logger& log, Step&& step) {
  try {
    step();
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
  for (auto& [mailbox, mail] : mail_) {
    Mailbox& box = *mailbox;
    std::vector<Mail>& letters = mail;
    log_failure(log_, [&] {
      box.put(std::move(letters));
      box.wake();
    });
  }
  mail_.clear();
  woke_ = clock_.now();
}

void deliver(const MailboxPtr& mailbox, Mail mail, const Logger& log) {
  log_failure(log, [&] {
    mailbox->put(std::move(mail));
    mailbox->wake();
  });
}

}  // namespace talus::server
