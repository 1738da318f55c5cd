#include "websocket/handshake.h"

#include <algorithm>
#include <array>
#include <cctype>

#include <openssl/evp.h>
#include <openssl/sha.h>

namespace talus::server::websocket {
namespace {

constexpr std::string_view kGuid = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";  // section 1.3
constexpr std::size_t kKeyCharacters = 24;                                  // of 16 bytes

/// Whether a list of words separated by commas has the word, in any case.
bool has_word(const std::string* list, std::string_view word) {
  if (list == nullptr) return false;
  const auto equal = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  };
  std::string_view rest{*list};
  for (;;) {
    const std::size_t comma = rest.find(',');
    std::string_view each = rest.substr(0, comma);
    while (!each.empty() && (each.front() == ' ' || each.front() == '\t')) each.remove_prefix(1);
    while (!each.empty() && (each.back() == ' ' || each.back() == '\t')) each.remove_suffix(1);
    if (std::equal(each.begin(), each.end(), word.begin(), word.end(), equal)) return true;
    if (comma == std::string_view::npos) return false;
    rest.remove_prefix(comma + 1);
  }
}

bool is_key(const std::string* key) {
  if (key == nullptr || key->size() != kKeyCharacters || !key->ends_with("==")) return false;
  return std::all_of(key->begin(), key->end() - 2, [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+' || c == '/';
  });
}

}  // namespace

std::string accept_key(std::string_view key) {
  const std::string text = std::string{key} + std::string{kGuid};
  std::array<unsigned char, SHA_DIGEST_LENGTH> digest{};
  SHA1(reinterpret_cast<const unsigned char*>(text.data()), text.size(), digest.data());
  std::array<unsigned char, 4 * ((SHA_DIGEST_LENGTH + 2) / 3) + 1> encoded{};
  EVP_EncodeBlock(encoded.data(), digest.data(), static_cast<int>(digest.size()));
  return reinterpret_cast<const char*>(encoded.data());
}

http::Response answer_handshake(const http::Request& request) {
  if (!request.upgrade || !has_word(request.field("Upgrade"), "websocket")) {
    return {426,
            http::kPlainText,
            "this is a WebSocket; ask with Connection: Upgrade and Upgrade: websocket\n",
            {{"Upgrade", "websocket"}}};
  }
  if (const std::string* const version = request.field("Sec-WebSocket-Version");
      version == nullptr || *version != "13") {
    return {426,
            http::kPlainText,
            "only version 13 of the WebSocket protocol is spoken here\n",
            {{"Upgrade", "websocket"}, {"Sec-WebSocket-Version", "13"}}};
  }
  const std::string* const key = request.field("Sec-WebSocket-Key");
  if (request.method != http::Method::get || !is_key(key)) {
    return {400, http::kPlainText,
            "a WebSocket begins with GET and a Sec-WebSocket-Key of 16 bytes in base64\n"};
  }
  return {101, "", "", {{"Upgrade", "websocket"}, {"Sec-WebSocket-Accept", accept_key(*key)}}};
}

}  // namespace talus::server::websocket
