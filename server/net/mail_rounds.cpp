#include "net/mail_rounds.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include <asio/post.hpp>

namespace talus::server {

void MailRounds::enter(std::shared_ptr<Reader> reader, const asio::any_io_executor& executor) {
  const std::lock_guard lock{mutex_};
  readers_.push_back(std::move(reader));
  if (readers_.size() > 1) return;
  try {
    asio::post(executor, [this, executor] { go_round(executor); });
  } catch (...) {
    readers_.pop_back();
    throw;
  }
}

void MailRounds::go_round(const asio::any_io_executor& executor) {
  std::vector<std::shared_ptr<Reader>> now;
  {
    const std::lock_guard lock{mutex_};
    if (readers_.size() <= kAtOnce) {
      now.swap(readers_);
    } else {
      // Before anything is taken: what throws leaves all where they are.
      asio::post(executor, [this, executor] { go_round(executor); });
      const auto first = readers_.begin();
      const auto end = first + static_cast<std::ptrdiff_t>(kAtOnce);
      now.assign(std::make_move_iterator(first), std::make_move_iterator(end));
      readers_.erase(first, end);
    }
  }
  for (const auto& reader : now) reader->read_mail();
}

void MailRounds::shutdown() noexcept {
  std::vector<std::shared_ptr<Reader>> none;
  const std::lock_guard lock{mutex_};
  readers_.swap(none);
}

}  // namespace talus::server
