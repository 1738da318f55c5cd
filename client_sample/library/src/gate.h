// Carries calls from other threads to an executor until it is closed.
#pragma once

#include <memory>
#include <mutex>
#include <utility>

#include <asio/any_io_executor.hpp>
#include <asio/post.hpp>

namespace talus::client {

/// After close() it does not touch the executor, whose context may then end.
class Gate {
 public:
  explicit Gate(asio::any_io_executor executor) : executor_{std::move(executor)} {}

  /// From any thread. Drops the call if the gate is closed.
  template <typename Call>
  void post(Call&& call) {
    const std::lock_guard lock{mutex_};
    if (open_) asio::post(executor_, std::forward<Call>(call));
  }
  void close() {
    const std::lock_guard lock{mutex_};
    open_ = false;
    executor_ = {};  // a strand must not outlive its context
  }

 private:
  std::mutex mutex_;
  bool open_ = true;
  asio::any_io_executor executor_;
};

}  // namespace talus::client
