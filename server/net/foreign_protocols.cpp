#include "net/foreign_protocols.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>

#include <fmt/format.h>

#include "net/http/response.h"

namespace talus::server {
namespace {

/// Returns the first four bytes, a little-endian length.
std::array<char, protocol::kPrefixBytes> first_bytes(const protocol::FrameError& error) {
  std::array<char, protocol::kPrefixBytes> bytes{};
  std::uint64_t length = error.claimed_bytes - protocol::kPrefixBytes;
  for (char& byte : bytes) {
    byte = static_cast<char>(length & 0xFF);
    length >>= 8;
  }
  return bytes;
}

}  // namespace

bool is_http_request(const protocol::FrameError& error) {
  constexpr std::array<std::string_view, 8> kBeginnings{"GET ", "HEAD", "POST", "PUT ",
                                                        "OPTI", "PRI ", "CONN", "DELE"};
  const auto bytes = first_bytes(error);
  return std::find(kBeginnings.begin(), kBeginnings.end(), std::string_view{bytes.data(), bytes.size()}) !=
         kBeginnings.end();
}

bool is_tls_hello(const protocol::FrameError& error) {
  const auto bytes = first_bytes(error);
  return bytes[0] == 0x16 && bytes[1] == 3;  // RFC 8446, 5.1: a handshake record
}

std::vector<std::byte> http_refusal(std::string_view line, std::chrono::sys_seconds now) {
  const http::Response response{400, http::kPlainText, fmt::format("{}\n", line)};
  std::string text;
  http::append_head(text, response, false, now);
  text += response.body;
  const auto bytes = std::as_bytes(std::span{text});
  return {bytes.begin(), bytes.end()};
}

}  // namespace talus::server
