#include <talus/websocket/client_side.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <utility>

#include <talus/protocol/header_fields.h>

#include "fields.h"

namespace talus::websocket {
namespace {

constexpr std::string_view kVersion = "HTTP/1.1 ";

}  // namespace

ClientSide::ClientSide(std::string_view host, std::string_view path,
                       std::span<const std::byte, kNonceBytes> nonce) {
  const std::string key = key_of(nonce);
  accept_ = accept_key(key);
  request_.append("GET ").append(path).append(" HTTP/1.1\r\nHost: ").append(host);
  request_.append("\r\nConnection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n");
  request_.append("Sec-WebSocket-Key: ").append(key).append("\r\n\r\n");
}

void ClientSide::fail(Failure::Kind kind, std::string text) {
  failure_ = Failure{kind, std::move(text)};
}

std::size_t ClientSide::take(std::span<std::byte> bytes) {
  if (failure_) return 0;
  if (!open_) {
    const std::size_t taken = take_answer({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    if (!open_) return 0;
    const std::size_t rest = bytes.size() - taken;
    if (rest > 0) std::memmove(bytes.data(), bytes.data() + taken, rest);
    bytes = bytes.first(rest);
  }
  const std::size_t payload = reader_.take(bytes);
  const End end = reader_.end();
  if (end == End::none) return payload;
  close_waits_ = close_code(end);
  if (end == End::closed) {
    fail(Failure::Kind::closed, "the server closed the WebSocket");
  } else {
    fail(Failure::Kind::violation, make_error_code(end).message());
  }
  return payload;
}

std::size_t ClientSide::take_answer(std::string_view text) {
  constexpr std::string_view kEnd = "\r\n\r\n";
  const std::size_t had = answer_.size();
  answer_.append(text.substr(0, std::min(text.size(), kMaxAnswerBytes - had)));
  if (const auto known = std::min(answer_.size(), kVersion.size());
      answer_.compare(0, known, kVersion, 0, known) != 0) {
    fail(Failure::Kind::violation, "the peer is not an HTTP/1.1 server");
    return text.size();
  }
  const std::size_t end = answer_.find(kEnd, had < kEnd.size() ? 0 : had - kEnd.size());
  if (end == std::string::npos) {
    if (answer_.size() == kMaxAnswerBytes) {
      fail(Failure::Kind::violation, "the answer to the WebSocket handshake is too long");
    }
    return text.size();
  }
  answer_.resize(end + kEnd.size());
  const std::size_t taken = answer_.size() - had;
  check_answer();
  std::string{}.swap(answer_);
  return taken;
}

// Section 4.1, from "If the status code received from the server is not 101".
void ClientSide::check_answer() {
  std::string_view rest{answer_};
  const std::string_view status_line = next_line(rest);
  int status = 0;
  constexpr std::size_t kStatusEnd = kVersion.size() + 3;
  const char* const digits = status_line.data() + kVersion.size();
  if (status_line.size() < kStatusEnd || std::from_chars(digits, digits + 3, status).ptr != digits + 3) {
    return fail(Failure::Kind::violation, "the answer to the WebSocket handshake has no status");
  }
  const Fields fields{rest};
  if (status != 101) {
    fail(Failure::Kind::refused,
         "the server answered " + printable(status_line.substr(kVersion.size())) + " instead of a WebSocket");
    failure_->status = status;
    const std::string wait = fields.list("Retry-After").value_or("");
    std::from_chars(wait.data(), wait.data() + wait.size(), failure_->retry_after_seconds);
    return;
  }
  if (!protocol::has_word(fields.list("Upgrade").value_or(""), "websocket") ||
      !protocol::has_word(fields.list("Connection").value_or(""), "upgrade")) {
    return fail(Failure::Kind::violation, "the server's 101 is not for a WebSocket");
  }
  if (fields.list("Sec-WebSocket-Accept") != accept_) {
    return fail(Failure::Kind::violation, "the server's Sec-WebSocket-Accept does not match the key");
  }
  if (fields.list("Sec-WebSocket-Extensions") || fields.list("Sec-WebSocket-Protocol")) {
    return fail(Failure::Kind::violation,
                "the server chose a WebSocket extension or subprotocol that was not offered");
  }
  open_ = true;
}

void ClientSide::append_control(std::vector<std::byte>& output, std::array<std::byte, 4> mask) {
  if (reader_.has_ping()) {
    append_pong(output, reader_.ping(), mask);
    reader_.pop_ping();
  } else if (const auto code = std::exchange(close_waits_, std::nullopt)) {
    append_close(output, *code, mask);
  }
}

}  // namespace talus::websocket
