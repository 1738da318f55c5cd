// Sessions that send Views without end.
#pragma once

#include <array>
#include <asio/buffer.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/read.hpp>
#include <asio/write.hpp>
#include <cstddef>
#include <cstdint>
#include <memory>
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
  ViewFlood(asio::io_context& io, const asio::ip::address& from, std::uint16_t port,
            const protocol::Frame& views)
      : socket_{io, {from, 0}}, views_{views} {
    socket_.connect({asio::ip::address_v4::loopback(), port});
    asio::write(socket_, asio::buffer(hello()));
    std::array<std::byte, 4> of_welcome;
    asio::read(socket_, asio::buffer(of_welcome));
    socket_.non_blocking(true);
  }

  /// As much as the server takes now.
  void go_on() {
    std::error_code failed;
    sent_ += socket_.write_some(asio::buffer(views_) + sent_ % views_.size(), failed);
    std::array<std::byte, 65536> dropped;
    while (socket_.read_some(asio::buffer(dropped), failed) > 0) continue;
  }
  [[nodiscard]] std::size_t sent_bytes() const { return sent_; }

 private:
  asio::ip::tcp::socket socket_;
  const protocol::Frame& views_;
  std::size_t sent_ = 0;
};

/// So many of them, from 127.0.0.1 and the following addresses, by a thread of their own until stop().
class ViewFloods {
 public:
  ViewFloods(std::size_t sessions, std::uint32_t addresses, std::uint16_t port) {
    for (std::size_t i = 0; i < sessions; ++i) {
      const asio::ip::address_v4 from{kLoopback + static_cast<std::uint32_t>(i % addresses)};
      floods_.push_back(std::make_unique<ViewFlood>(io_, from, port, views_));
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
  asio::io_context io_;
  std::vector<std::unique_ptr<ViewFlood>> floods_;
  std::jthread attack_;
};

}  // namespace talus::e2e
