#include "net/websocket/handshake.h"

#include <algorithm>
#include <cctype>
#include <string>

#include <talus/protocol/header_fields.h>
#include <talus/websocket/handshake.h>

namespace talus::server::websocket {
namespace {

constexpr std::size_t kKeyCharacters = 24;  // 16 bytes in base64

bool is_key(std::string_view key) {
  if (key.size() != kKeyCharacters || !key.ends_with("==")) return false;
  return std::all_of(key.begin(), key.end() - 2, [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+' || c == '/';
  });
}

}  // namespace

http::Response answer_handshake(const http::Request& request) {
  if (!request.upgrade || !protocol::has_word(request.list("Upgrade"), "websocket")) {
    return {426,
            http::kPlainText,
            "this is a WebSocket; ask with Connection: Upgrade and Upgrade: websocket\n",
            {{"Upgrade", "websocket"}}};
  }
  if (request.list("Sec-WebSocket-Version") != "13") {
    return {426,
            http::kPlainText,
            "this server supports only version 13 of the WebSocket protocol\n",
            {{"Upgrade", "websocket"}, {"Sec-WebSocket-Version", "13"}}};
  }
  const std::string key = request.list("Sec-WebSocket-Key");
  if (request.method != http::Method::get || !is_key(key)) {
    return {400, http::kPlainText,
            "a WebSocket begins with GET and a Sec-WebSocket-Key of 16 bytes in base64\n"};
  }
  return {
      101, "", "", {{"Upgrade", "websocket"}, {"Sec-WebSocket-Accept", talus::websocket::accept_key(key)}}};
}

}  // namespace talus::server::websocket
