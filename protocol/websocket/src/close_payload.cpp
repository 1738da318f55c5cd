#include "close_payload.h"

#include <string>

#include <flatbuffers/util.h>

namespace talus::websocket {
namespace {

/// Codes of the RFC that may be sent, codes registered with IANA, and codes of libraries and applications.
/// 1004 to 1006 and 1015 are reserved for local use.
bool may_be_sent(unsigned code) {
  return (code >= 1000 && code <= 1003) || (code >= 1007 && code <= 1014) || (code >= 3000 && code <= 4999);
}

bool is_utf8(const std::string& text) {
  const char* at = text.c_str();  // FromUTF8() stops at the terminating NUL
  while (at < text.c_str() + text.size()) {
    if (flatbuffers::FromUTF8(&at) < 0) return false;
  }
  return true;
}

}  // namespace

End end_by_close(std::span<const std::byte> payload) {
  constexpr std::size_t kCodeBytes = 2;
  if (payload.empty()) return End::closed;
  if (payload.size() < kCodeBytes) return End::malformed_close;
  const auto code = std::to_integer<unsigned>(payload[0]) << 8 | std::to_integer<unsigned>(payload[1]);
  if (!may_be_sent(code)) return End::bad_close_code;
  const auto reason = payload.subspan(kCodeBytes);
  const bool readable = is_utf8({reinterpret_cast<const char*>(reason.data()), reason.size()});
  return readable ? End::closed : End::bad_close_reason;
}

}  // namespace talus::websocket
