#include "net/mail_rounds.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include <asio/post.hpp>

namespace talus::server {

void MailRounds::enter(std::shared_ptr<Reader> reader, const asio::any_io_executor& executor) {
  const Reader* const entered = reader.get();
  {
    const std::lock_guard lock{mutex_};
    readers_.push_back(std::move(reader));
    if (std::exchange(posted_, true)) return;
  }
  // Without the lock, which the woken thread takes first.
  try {
    asio::post(executor, [this, executor] { go_round(executor); });
  } catch (...) {
    const std::lock_guard lock{mutex_};
    posted_ = false;
    std::erase_if(readers_, [&](const auto& each) { return each.get() == entered; });
    throw;
  }
}

void MailRounds::go_round(const asio::any_io_executor& executor) {
  for (std::size_t left = kAtOnce; take(left); left -= now_.size()) {
    for (const auto& reader : now_) reader->read_mail();
    if (left > now_.size()) continue;
    try {
      asio::post(executor, [this, executor] { go_round(executor); });
    } catch (...) {
      const std::lock_guard lock{mutex_};
      posted_ = false;
      throw;
    }
    break;
  }
  now_.clear();
}

bool MailRounds::take(std::size_t most) {
  now_.clear();
  const std::lock_guard lock{mutex_};
  const auto first = readers_.begin();
  const auto end = first + static_cast<std::ptrdiff_t>(std::min(readers_.size(), most));
  now_.assign(std::make_move_iterator(first), std::make_move_iterator(end));
  readers_.erase(first, end);
  if (now_.empty()) posted_ = false;
  return !now_.empty();
}

void MailRounds::shutdown() noexcept {
  std::vector<std::shared_ptr<Reader>> none;
  const std::lock_guard lock{mutex_};
  readers_.swap(none);
}

}  // namespace talus::server
