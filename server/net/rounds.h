// Lets many readers of one io_context read by one posted handler: one each would cost the thread that wakes
// them an allocation, a lock that the context's thread wants too, and mostly a system call. Sessions read
// their mail so, as a batch of edits is answered to many at once, and HTTP connections their next request.
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
  /// Maximum number of readers of one handler; then other handlers of the context have their turn.
  static constexpr std::size_t kAtOnce = 32;

  explicit Rounds(asio::execution_context& context) : service{context} { now_.reserve(kAtOnce); }

  /// From any thread: reader->read() is called soon, on `executor`, which is of the context, after the
  /// handlers that wait there. Throws std::bad_alloc, and then it is not, and a reader that entered at the
  /// same moment reads with the next.
  void enter(std::shared_ptr<Reader> reader, const asio::any_io_executor& executor) {
    const Reader* const entered = reader.get();
    {
      const std::lock_guard lock{mutex_};
      readers_.push_back(std::move(reader));
      if (std::exchange(posted_, true)) return;
    }
    // Without the lock: it is the first thing that the thread takes which this wakes.
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
  /// Lets all readers read that have entered, also since it began, so that these need no handler of their
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
  /// Moves at most `most` readers, the first that entered, to now_. False if there are none: the next that
  /// enters posts.
  [[nodiscard]] bool take(std::size_t most) {
    now_.clear();
    const std::lock_guard lock{mutex_};
    const auto first = readers_.begin();
    const auto end = first + static_cast<std::ptrdiff_t>(std::min(readers_.size(), most));
    now_.assign(std::make_move_iterator(first), std::make_move_iterator(end));
    readers_.erase(first, end);
    if (now_.empty()) posted_ = false;
    return !now_.empty();
  }

  std::mutex mutex_;
  std::vector<std::shared_ptr<Reader>> readers_;
  bool posted_ = false;                       // a handler that takes them
  std::vector<std::shared_ptr<Reader>> now_;  // of go_round(); has memory for kAtOnce
};

}  // namespace talus::server
