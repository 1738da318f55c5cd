// Entries that wait for a log's thread: bounded, in the order in which they came.
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

#include "edits/edit_log.h"

namespace talus::server {

/// What waits for the log at most, in all.
struct EntryQueueLimits {
  std::size_t entries = 8'192;
  std::size_t bytes = std::size_t{32} << 20U;
};

/// Of one entry: `Entry` as the log has it. Any thread puts, one takes.
template <typename Entry>
class EntryQueue {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  struct Waiting {
    Entry entry;
    EditLog::Done done;
    std::size_t bytes = 0;
  };

  explicit EntryQueue(const EntryQueueLimits& limits) : limits_{limits} {}

  [[nodiscard]] tl::expected<void, LogFailure> put(Waiting waiting) {
    using Kind = LogFailure::Kind;
    bool wakes = false;
    {
      const std::lock_guard lock{mutex_};
      if (stopping_) return tl::unexpected{LogFailure{Kind::busy, "this server is about to end"}};
      if (waiting_now() >= limits_.entries || bytes_ + waiting.bytes > limits_.bytes) {
        return tl::unexpected{LogFailure{Kind::busy, "as many edits wait to be written as may"}};
      }
      wakes = waiting_now() == 0;
      bytes_ += waiting.bytes;
      queue_.push_back(std::move(waiting));
    }
    if (wakes) wake_.notify_one();
    return {};
  }

  /// What waits, at most so many entries, and so many bytes but for the first. Waits for it itself, until
  /// `until`, stop() or wake(); TimePoint::min(): not at all. `taken`, whose memory is used again, is empty.
  [[nodiscard]] std::vector<Waiting> take(std::size_t most, std::size_t most_bytes, TimePoint until,
                                          std::vector<Waiting> taken = {}) {
    std::unique_lock lock{mutex_};
    if (until != TimePoint::min()) {
      wake_.wait_until(lock, until, [&] { return stopping_ || woken_ || waiting_now() != 0; });
      woken_ = false;
    }
    if (first_ == 0 && queue_.size() <= most && bytes_ <= most_bytes) {  // mostly all
      queue_.swap(taken);
      bytes_ = 0;
      return taken;
    }
    taken.reserve(std::min(waiting_now(), most));
    std::size_t bytes = 0;
    while (waiting_now() != 0 && taken.size() < most) {
      const std::size_t size = queue_[first_].bytes;
      if (!taken.empty() && bytes + size > most_bytes) break;
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

  /// The take() under way, or the next that would, does not wait. Any thread.
  void wake() {
    {
      const std::lock_guard lock{mutex_};
      woken_ = true;
    }
    wake_.notify_one();
  }

  /// put() takes nothing any more, and take() does not wait. Any thread.
  void stop() {
    {
      const std::lock_guard lock{mutex_};
      stopping_ = true;
    }
    wake_.notify_one();
  }
  /// It stops, and all was taken.
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
  std::vector<Waiting> queue_;
  std::size_t first_ = 0;  // of the queue that was not taken yet
  std::size_t bytes_ = 0;
  bool stopping_ = false;
  bool woken_ = false;
};

}  // namespace talus::server
