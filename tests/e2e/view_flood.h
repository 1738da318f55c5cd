// Sessions that send Views without end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stop_token>
#include <thread>
#include <vector>

#include "messages.h"
#include "raw_client.h"

namespace talus::e2e {

/// Large Views, each of other chunks than the one before it.
inline protocol::Frame many_views() {
  protocol::Frame views;
  for (int i = 0; i < 256; ++i) {
    const auto one =
        view({.centre = {i * 100'000, 100, -i * 50'000}, .horizontal_radius = 40, .vertical_radius = 4});
    views.insert(views.end(), one.begin(), one.end());
  }
  return views;
}

/// A session that sends Views without end, and drops what it is sent.
class ViewFlood {
 public:
  /// Connects to 127.0.0.1 from `from`, and has joined when this returns. `views` outlives it.
  ViewFlood(std::uint32_t from, std::uint16_t port, const protocol::Frame& views)
      : client_{greeted(port, 0, from)}, views_{views} {}

  /// As much as the server takes now. From any one thread.
  void go_on() {
    sent_ += client_.send_some(std::span{views_}.subspan(sent_ % views_.size())).value_or(0);
    client_.drop_received();
  }
  [[nodiscard]] std::size_t sent_bytes() const { return sent_; }

 private:
  RawClient client_;
  const protocol::Frame& views_;
  std::size_t sent_ = 0;
};

/// So many of them, from 127.0.0.1 and the following addresses, by a thread of their own until stop().
class ViewFloods {
 public:
  ViewFloods(std::size_t sessions, std::uint32_t addresses, std::uint16_t port) {
    for (std::size_t i = 0; i < sessions; ++i) {
      const std::uint32_t from = kLoopback + static_cast<std::uint32_t>(i % addresses);
      floods_.push_back(std::make_unique<ViewFlood>(from, port, views_));
    }
    attack_ = std::jthread{[this](const std::stop_token& stop) {
      while (!stop.stop_requested()) {
        for (const auto& session : floods_) session->go_on();
      }
    }};
  }

  /// About how many Views were sent.
  std::size_t stop() {
    attack_.request_stop();
    attack_.join();
    std::size_t bytes = 0;
    for (const auto& session : floods_) bytes += session->sent_bytes();
    return bytes / (views_.size() / 256);
  }

 private:
  const protocol::Frame views_ = many_views();
  std::vector<std::unique_ptr<ViewFlood>> floods_;
  std::jthread attack_;
};

}  // namespace talus::e2e
