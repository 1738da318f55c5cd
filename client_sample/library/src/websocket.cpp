#include <talus/client/websocket.h>

#include <algorithm>
#include <cstring>
#include <random>

namespace talus::client {
namespace {

using websocket::Failure;

template <std::size_t kBytes>
std::array<std::byte, kBytes> random_bytes() {
  thread_local std::random_device device;  // the system's randomness: unpredictable
  std::array<std::byte, kBytes> bytes{};
  for (std::size_t at = 0; at < kBytes; at += sizeof(std::uint32_t)) {
    const std::uint32_t some = device();
    std::memcpy(bytes.data() + at, &some, sizeof(some));
  }
  return bytes;
}

/// True if the text can stand in a request line: no spaces or control characters.
bool is_printable(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c > ' ' && c <= '~'; });
}

ErrorKind kind_of(const Failure& failure) {
  switch (failure.kind) {
    case Failure::Kind::closed:
      return ErrorKind::disconnected;
    case Failure::Kind::violation:
      return ErrorKind::broken_protocol;
    case Failure::Kind::refused:
      break;
  }
  if (failure.status == 401 || failure.status == 403) return ErrorKind::refused;
  return failure.status == 429 || failure.status == 503 ? ErrorKind::overloaded : ErrorKind::unreachable;
}

}  // namespace

Result<websocket::ClientSide> new_websocket(const WebSocketOptions& options, const std::string& host,
                                            const std::string& port) {
  const auto wrong = [](std::string what) {
    return tl::unexpected{ClientError{ErrorKind::unreachable, std::move(what), {}}};
  };
  if (!websocket::can_shake_hands())
    return wrong("this client was built without TLS, and so without WebSocket");
  const bool bracketed = host.find(':') != std::string::npos;
  const std::string named =
      options.host.empty() ? (bracketed ? "[" + host + "]" : host) + ":" + port : options.host;
  if (!is_printable(named)) return wrong("the WebSocket's host is neither a name nor an address");
  if (!options.path.starts_with('/') || !is_printable(options.path)) {
    return wrong(
        "the WebSocket's path must begin with / and have neither spaces nor control characters; "
        "talusd's is /v1/stream");
  }
  const auto nonce = random_bytes<websocket::kNonceBytes>();
  return websocket::ClientSide{named, options.path, nonce};
}

std::array<std::byte, 4> random_mask() {
  return random_bytes<4>();
}

ClientError error_of(const Failure& failure) {
  // Longer waits than the client would accept are capped.
  const auto seconds = std::min<std::uint32_t>(failure.retry_after_seconds, 3600);
  return {kind_of(failure), failure.text, std::chrono::seconds{seconds}};
}

}  // namespace talus::client
