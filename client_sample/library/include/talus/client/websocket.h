// A Client's WebSocket layer, only for programs that open additional connections themselves.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include <talus/client/error.h>
#include <talus/client/options.h>
#include <talus/websocket/client_side.h>

namespace talus::client {

/// Creates the client side of one connection to HOST:PORT. An error states what is wrong with the options.
[[nodiscard]] Result<websocket::ClientSide> new_websocket(const WebSocketOptions& options,
                                                          const std::string& host, const std::string& port);

/// The masking key of one frame.
[[nodiscard]] std::array<std::byte, 4> random_mask();

[[nodiscard]] ClientError error_of(const websocket::Failure& failure);

}  // namespace talus::client
