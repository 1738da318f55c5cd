// Whether more than one client has asked for work of late. For one thread; GenerationPool locks.
#pragma once

#include <chrono>

#include "chunks/mailbox.h"
#include "clock/clock.h"

namespace talus::server {

class RecentClients {
 public:
  /// For which a client that asked counts as going on to ask.
  static constexpr std::chrono::seconds kRecently{1};

  void asked(ClientId client, Clock::time_point now) {
    if (client != last_client_ && now - last_asked_ < kRecently) two_asked_ = now;
    last_client_ = client;
    last_asked_ = now;
  }
  /// Whether two asked within kRecently of each other, not longer ago than that.
  [[nodiscard]] bool several(Clock::time_point now) const { return now - two_asked_ <= kRecently; }

 private:
  ClientId last_client_{};
  Clock::time_point last_asked_{};
  Clock::time_point two_asked_{};
};

}  // namespace talus::server
