// A clock that a test moves.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <asio/error.hpp>
#include <asio/post.hpp>

#include <talus/client/clock.h>

namespace talus::client::testing {

/// For one thread. Its timers may outlive it only if nobody waits on them.
class ManualClock final : public Clock {
 public:
  [[nodiscard]] Time now() const override { return now_; }
  [[nodiscard]] std::unique_ptr<Timer> make_timer(const asio::any_io_executor& executor) override;

  /// Ends the waits that are due by then; their handlers run on their executors.
  void advance(std::chrono::nanoseconds time) {
    now_ += time;
    for (const auto& wait : std::exchange(waits_, {})) {
      if (!wait->handler) continue;
      if (wait->end <= now_) {
        wait->finish({});
      } else {
        waits_.push_back(wait);
      }
    }
  }

  /// The time of the next wait that ends; none where nobody waits.
  [[nodiscard]] std::optional<Time> next() const {
    std::optional<Time> next;
    for (const auto& wait : waits_) {
      if (wait->handler && (!next || wait->end < *next)) next = wait->end;
    }
    return next;
  }

 private:
  struct Wait {
    asio::any_io_executor executor;
    Time end;
    Timer::Handler handler;

    void finish(std::error_code error) {
      asio::post(executor, [handler = std::exchange(handler, nullptr), error] { handler(error); });
    }
  };
  class ManualTimer;

  Time now_{std::chrono::hours{1}};
  std::vector<std::shared_ptr<Wait>> waits_;
};

class ManualClock::ManualTimer final : public Timer {
 public:
  ManualTimer(ManualClock& clock, asio::any_io_executor executor)
      : clock_{clock}, executor_{std::move(executor)} {}
  ManualTimer(const ManualTimer&) = delete;
  ManualTimer& operator=(const ManualTimer&) = delete;
  ~ManualTimer() override { ManualTimer::cancel(); }

  void async_wait_until(Time end, Handler handler) override {
    cancel();
    wait_ = std::make_shared<Wait>(Wait{executor_, end, std::move(handler)});
    if (end <= clock_.now()) return wait_->finish({});
    clock_.waits_.push_back(wait_);
  }
  void cancel() override {
    if (wait_ && wait_->handler) wait_->finish(asio::error::operation_aborted);
  }

 private:
  ManualClock& clock_;
  asio::any_io_executor executor_;
  std::shared_ptr<Wait> wait_;
};

inline std::unique_ptr<Timer> ManualClock::make_timer(const asio::any_io_executor& executor) {
  return std::make_unique<ManualTimer>(*this, executor);
}

}  // namespace talus::client::testing
