// WebSocket as a Client does it, for those who make connections of their own beside one. Nobody else needs
// this.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include <talus/client/error.h>
#include <talus/client/options.h>
#include <talus/websocket/client_side.h>

namespace talus::client {

/// The client's side of one connection to HOST:PORT. An error says what is wrong with the options.
[[nodiscard]] Result<websocket::ClientSide> new_websocket(const WebSocketOptions& options,
                                                          const std::string& host, const std::string& port);

/// For one frame.
[[nodiscard]] std::array<std::byte, 4> random_mask();

[[nodiscard]] ClientError error_of(const websocket::Failure& failure);

}  // namespace talus::client
