// Entries that wait for a log's thread: a bounded FIFO.
#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "edits/edit_log.h"

namespace talus::server {

/// Limits of all entries that wait for the log.
struct EntryQueueLimits {
  std::size_t entries = 8'192;
  std::size_t bytes = std::size_t{32} << 20U;
};

/// Any thread puts, one takes. `Entry` is the form in which the log keeps an entry.
template <typename Entry>
class EntryQueue {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  struct Item {
    Entry entry;
    EditLog::Callback done;
    std::size_t bytes = 0;
  };

  explicit EntryQueue(const EntryQueueLimits& limits) : limits_{limits} {}

  [[nodiscard]] tl::expected<void, EditError> put(Item item) {
    bool wakes = false;
    {
      const std::lock_guard lock{mutex_};
      if (stopping_) return edit_error(EditErrorCode::busy, "this server is shutting down");
      if (waiting_now() >= limits_.entries || bytes_ + item.bytes > limits_.bytes) {
        return edit_error(
            EditErrorCode::busy,
            fmt::format("the queue of the edit log is full (limit {} entries, {} bytes); retry later",
                        limits_.entries, limits_.bytes));
      }
      wakes = waiting_now() == 0;
      bytes_ += item.bytes;
      queue_.push_back(std::move(item));
    }
    if (wakes) wake_.notify_one();
    return {};
  }

  /// Removes and returns at most `max_items` entries and, except for the first, `max_bytes`. Blocks while the
  /// queue is empty, until `until`, stop() or wake(); TimePoint::min() never blocks. `taken` is empty; its
  /// memory is reused.
  [[nodiscard]] std::vector<Item> take(std::size_t max_items, std::size_t max_bytes, TimePoint until,
                                       std::vector<Item> taken = {}) {
    std::unique_lock lock{mutex_};
    if (until != TimePoint::min()) {
      wake_.wait_until(lock, until, [&] { return stopping_ || woken_ || waiting_now() != 0; });
      woken_ = false;
    }
    if (first_ == 0 && queue_.size() <= max_items && bytes_ <= max_bytes) {  // the usual case: all
      queue_.swap(taken);
      bytes_ = 0;
      return taken;
    }
    taken.reserve(std::min(waiting_now(), max_items));
    std::size_t bytes = 0;
    while (waiting_now() != 0 && taken.size() < max_items) {
      const std::size_t size = queue_[first_].bytes;
      if (!taken.empty() && bytes + size > max_bytes) break;
      bytes += size;
      bytes_ -= size;
      taken.push_back(std::move(queue_[first_++]));
    }
    if (2 * first_ >= queue_.size()) {
      queue_.erase(queue_.begin(), queue_.begin() + static_cast<std::ptrdiff_t>(first_));
      first_ = 0;
    }
    return taken;
  }

  /// Unblocks the current take(), or the next that would block. Any thread.
  void wake() {
    {
      const std::lock_guard lock{mutex_};
      woken_ = true;
    }
    wake_.notify_one();
  }

  /// From here on put() fails and take() does not block. Any thread.
  void stop() {
    {
      const std::lock_guard lock{mutex_};
      stopping_ = true;
    }
    wake_.notify_one();
  }
  /// Returns true after stop() if the queue is empty.
  [[nodiscard]] bool ended() const {
    const std::lock_guard lock{mutex_};
    return stopping_ && waiting_now() == 0;
  }
  [[nodiscard]] std::size_t size() const {
    const std::lock_guard lock{mutex_};
    return waiting_now();
  }

 private:
  [[nodiscard]] std::size_t waiting_now() const { return queue_.size() - first_; }

  const EntryQueueLimits limits_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::vector<Item> queue_;
  std::size_t first_ = 0;  // index of the first entry that is not taken yet
  std::size_t bytes_ = 0;
  bool stopping_ = false;
  bool woken_ = false;
};

}  // namespace talus::server
