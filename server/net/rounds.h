// Lets many readers of one io_context read by one posted handler. One handler for each would cost the thread
// that wakes them an allocation, a lock that the context's thread also takes, and usually a system call.
// Sessions read their mail so, as one batch of edits answers many, and HTTP connections their next requests.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include <asio/any_io_executor.hpp>
#include <asio/execution_context.hpp>
#include <asio/post.hpp>

namespace talus::server {

/// One for each io_context and type of reader (asio::use_service).
template <typename Reader>
class Rounds final : public asio::execution_context::service {
 public:
  static inline asio::execution_context::id id;
  /// Readers served by one handler before other handlers of the context run.
  static constexpr std::size_t kAtOnce = 32;

  explicit Rounds(asio::execution_context& context) : service{context} { now_.reserve(kAtOnce); }

  /// From any thread: calls reader->read() soon, after the handlers that wait there, on `executor`, which
  /// belongs to the context. Throws if out of memory; then `reader` is not entered, and one entered by
  /// another thread at that moment is served with the next.
  void enter(std::shared_ptr<Reader> reader, const asio::any_io_executor& executor) {
    const Reader* const entered = reader.get();
    {
      const std::lock_guard lock{mutex_};
      readers_.push_back(std::move(reader));
      if (std::exchange(posted_, true)) return;
    }
    // Without the lock, which is the first thing that the woken thread takes.
    try {
      post(executor);
    } catch (...) {
      const std::lock_guard lock{mutex_};
      std::erase_if(readers_, [&](const auto& each) { return each.get() == entered; });
      throw;
    }
  }

 private:
  void shutdown() noexcept override {
    std::vector<std::shared_ptr<Reader>> readers;
    const std::lock_guard lock{mutex_};
    readers_.swap(readers);
  }

  void post(const asio::any_io_executor& executor) {
    try {
      asio::post(executor, [this, executor] { go_round(executor); });
    } catch (...) {
      const std::lock_guard lock{mutex_};
      posted_ = false;
      throw;
    }
  }
  /// Serves all entered readers, including readers entered meanwhile, which then need no handler of their
  /// own.
  void go_round(const asio::any_io_executor& executor) {
    for (std::size_t left = kAtOnce; take(left); left -= now_.size()) {
      for (const auto& reader : now_) reader->read();
      if (left > now_.size()) continue;
      post(executor);
      break;
    }
    now_.clear();
  }
  /// Moves at most `max_readers` readers to now_, in the order in which they entered. Returns false if there
  /// are no more; the next to enter posts a handler.
  [[nodiscard]] bool take(std::size_t max_readers) {
    now_.clear();
    const std::lock_guard lock{mutex_};
    const auto first = readers_.begin();
    const auto end = first + static_cast<std::ptrdiff_t>(std::min(readers_.size(), max_readers));
    now_.assign(std::make_move_iterator(first), std::make_move_iterator(end));
    readers_.erase(first, end);
    if (now_.empty()) posted_ = false;
    return !now_.empty();
  }

  std::mutex mutex_;
  std::vector<std::shared_ptr<Reader>> readers_;
  bool posted_ = false;                       // true while a handler waits or runs
  std::vector<std::shared_ptr<Reader>> now_;  // of go_round(); has memory for kAtOnce
};

}  // namespace talus::server
