// Refused connections: each gets a message and is then closed. Flows share their number (flow_shares.h).
#pragma once

#include <cstddef>
#include <vector>

#include <asio/ip/tcp.hpp>

#include "limits/flows/flow_shares.h"
#include "runtime/clock.h"

namespace talus::server {

class Refusals {
 public:
  /// Maximum number of refusals in flight; any more are closed without a message.
  static constexpr std::size_t kMax = 64;
  /// Additional refusals on spare descriptors.
  static constexpr std::size_t kMaxSpare = 4;

  /// Sends `message` and closes after the client has had time to read it. Must outlive the socket's
  /// io_context.
  void refuse(asio::ip::tcp::socket socket, std::vector<std::byte> message, FlowId flow,
              Clock::time_point now);

 private:
  FlowShares in_flight_{Clock::duration::max()};  // each ends soon
  FlowShares spare_in_flight_{Clock::duration::max()};
};

}  // namespace talus::server
