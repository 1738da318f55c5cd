// Keys of a WebSocket's opening handshake. Source: RFC 6455, sections 1.3 and 4.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace talus::websocket {

/// False in builds without OpenSSL, whose SHA-1 the handshake needs: they cannot open WebSockets.
[[nodiscard]] bool can_shake_hands();

inline constexpr std::size_t kNonceBytes = 16;
/// The client's Sec-WebSocket-Key. `nonce`: random bytes.
[[nodiscard]] std::string key_of(std::span<const std::byte, kNonceBytes> nonce);
/// The server's Sec-WebSocket-Accept for a key.
[[nodiscard]] std::string accept_key(std::string_view key);

}  // namespace talus::websocket
