#include "chunks/generation/answer_batcher.h"

#include <exception>
#include <new>
#include <utility>

namespace talus::server {
namespace {

// A failure of one client must not keep the answers from the others, nor end the thread. What failed for lack
// of memory is tried again, as much may be free a moment later; the mailbox records what is lost then.
template <typename Step>
void do_or_lose(Mailbox& mailbox, const Logger& log, Step&& step) {
  try {
    try {
      step();
    } catch (const std::bad_alloc&) {
      step();
    }
  } catch (const std::exception& error) {
    mailbox.lose_mail();
    log->error("an answer could not be delivered: {}", error.what());
  }
}

}  // namespace

void AnswerBatcher::add(std::span<const Waiter> waiters, ChunkKey key, const ChunkAnswer& answer) {
  for (const Waiter& waiter : waiters) {
    do_or_lose(*waiter.mailbox, log_, [&] { mail_[waiter.mailbox].emplace_back(ChunkReady{key, answer}); });
  }
  if (!mail_.empty() && clock_.now() - woke_ >= kInterval) wake();
}

void AnswerBatcher::wake() {
  for (auto& each : mail_) {
    do_or_lose(*each.first, log_, [&] { each.first->put(std::move(each.second)); });
    do_or_lose(*each.first, log_, [&] { each.first->wake(); });
  }
  mail_.clear();
  woke_ = clock_.now();
}

void deliver(const MailboxPtr& mailbox, Mail mail, const Logger& log) {
  std::vector<Mail> letters;
  do_or_lose(*mailbox, log, [&] { letters.reserve(1); });
  if (letters.capacity() == 0) return;
  letters.push_back(std::move(mail));
  do_or_lose(*mailbox, log, [&] { mailbox->put(std::move(letters)); });
  do_or_lose(*mailbox, log, [&] { mailbox->wake(); });
}

}  // namespace talus::server
