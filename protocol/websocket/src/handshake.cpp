#include <talus/websocket/handshake.h>

#include <array>

#include <openssl/evp.h>
#include <openssl/sha.h>

namespace talus::websocket {
namespace {

constexpr std::string_view kGuid = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";  // section 1.3

template <std::size_t kBytes>
std::string base64(const unsigned char* bytes) {
  std::array<unsigned char, 4 * ((kBytes + 2) / 3) + 1> encoded{};
  EVP_EncodeBlock(encoded.data(), bytes, static_cast<int>(kBytes));
  return reinterpret_cast<const char*>(encoded.data());
}

}  // namespace

bool can_shake_hands() {
  return true;
}

std::string key_of(std::span<const std::byte, kNonceBytes> nonce) {
  return base64<kNonceBytes>(reinterpret_cast<const unsigned char*>(nonce.data()));
}

std::string accept_key(std::string_view key) {
  const std::string text = std::string{key} + std::string{kGuid};
  std::array<unsigned char, SHA_DIGEST_LENGTH> digest{};
  SHA1(reinterpret_cast<const unsigned char*>(text.data()), text.size(), digest.data());
  return base64<SHA_DIGEST_LENGTH>(digest.data());
}

}  // namespace talus::websocket
