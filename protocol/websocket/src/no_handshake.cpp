// Replaces handshake.cpp if OpenSSL is not used (TALUS_TLS=OFF).
#include <talus/websocket/handshake.h>

namespace talus::websocket {

bool can_shake_hands() {
  return false;
}

std::string key_of(std::span<const std::byte, kNonceBytes> /*nonce*/) {
  return {};
}

std::string accept_key(std::string_view /*key*/) {
  return {};
}

}  // namespace talus::websocket
