#include <talus/websocket/frame_reader.h>

#include <algorithm>
#include <cstring>
#include <string>

#include <flatbuffers/util.h>

namespace talus::websocket {
namespace {

constexpr std::byte kFinal{0x80};
constexpr std::byte kReserved{0x70};
constexpr std::byte kOpcode{0x0F};
constexpr std::byte kMasked{0x80};
constexpr std::byte kLength{0x7F};
constexpr std::uint8_t kLength16 = 126;  // two bytes of length follow
constexpr std::uint8_t kLength64 = 127;  // eight bytes of length follow

class Category final : public std::error_category {
 public:
  [[nodiscard]] const char* name() const noexcept override { return "websocket"; }
  [[nodiscard]] std::string message(int end) const override {
    constexpr std::array kTexts{"nothing is wrong",
                                "closed by the other end",
                                "a client's WebSocket frame is not masked",
                                "a server's WebSocket frame is masked",
                                "a WebSocket frame has a reserved bit set",
                                "a WebSocket frame has an unknown opcode",
                                "a WebSocket message is text; it must be binary",
                                "a WebSocket continuation frame comes without a message",
                                "a WebSocket message begins inside another",
                                "a WebSocket frame's length is over 2^63 - 1",
                                "a WebSocket control frame is fragmented",
                                "a WebSocket control frame has more than 125 bytes",
                                "a WebSocket frame's length is in more bytes than it needs",
                                "a WebSocket Close frame has one byte",
                                "a WebSocket Close frame has a code that may not be sent",
                                "a WebSocket Close frame's reason is not UTF-8"};
    static_assert(kTexts.size() == static_cast<std::size_t>(End::bad_close_reason) + 1);
    return kTexts.at(static_cast<std::size_t>(end));
  }
};

std::uint8_t length_of(std::byte second) {
  return std::to_integer<std::uint8_t>(second & kLength);
}

/// Section 5.2: the length must use the fewest bytes that hold it.
bool is_minimal(std::uint8_t length, std::uint64_t bytes) {
  return length < kLength16 || (length == kLength16 ? bytes >= kLength16 : bytes > 0xFFFF);
}

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

/// End::closed, or the error in a Close frame's payload. Source: RFC 6455, sections 5.5.1 and 7.4.
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

}  // namespace

std::error_code make_error_code(End end) {
  static const Category category;
  return {static_cast<int>(end), category};
}

CloseCode close_code(End end) {
  if (end == End::text) return CloseCode::unsupported_data;
  if (end == End::bad_close_reason) return CloseCode::invalid_payload;
  return end == End::none || end == End::closed ? CloseCode::normal : CloseCode::protocol_error;
}

std::size_t FrameReader::head_bytes() const {
  if (head_filled_ < 2) return 2;
  const std::uint8_t length = length_of(head_[1]);
  return 2 +
         (length == kLength16   ? 2U
          : length == kLength64 ? 8U
                                : 0U) +
         (sender_ == Sender::client ? mask_.size() : 0);
}

std::size_t FrameReader::take(std::span<std::byte> bytes) {
  std::size_t kept = 0;
  std::size_t at = 0;
  while (end_ == End::none && (at < bytes.size() || (in_frame_ && frame_taken_ == frame_bytes_))) {
    if (!in_frame_) {
      head_[head_filled_++] = bytes[at++];
      // Errors are reported as early as possible.
      const bool masked = (head_[1] & kMasked) != std::byte{0};
      if (head_filled_ == 2 && masked != (sender_ == Sender::client)) {
        end_ = masked ? End::masked : End::not_masked;
      }
      if (end_ == End::none && head_filled_ == head_bytes()) begin_frame();
      continue;
    }
    const std::size_t piece =
        static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size() - at, frame_bytes_ - frame_taken_));
    std::byte* const into = is_control() ? control_.data() + frame_taken_ : bytes.data() + kept;
    if (sender_ == Sender::client) {
      for (std::size_t i = 0; i < piece; ++i)
        into[i] = bytes[at + i] ^ mask_[(frame_taken_ + i) % mask_.size()];
    } else if (piece > 0) {
      std::memmove(into, bytes.data() + at, piece);
    }
    if (!is_control()) kept += piece;
    at += piece;
    frame_taken_ += piece;
    if (frame_taken_ == frame_bytes_) end_frame();
  }
  return kept;
}

std::uint64_t FrameReader::payload_bytes() const {
  const std::uint8_t length = length_of(head_[1]);
  if (length < kLength16) return length;
  std::uint64_t bytes = 0;
  for (std::size_t i = 2; i < (length == kLength16 ? 4U : 10U); ++i) {
    bytes = bytes << 8 | std::to_integer<std::uint64_t>(head_[i]);
  }
  return bytes;
}

void FrameReader::begin_frame() {
  opcode_ = static_cast<Opcode>(head_[0] & kOpcode);
  last_ = (head_[0] & kFinal) != std::byte{0};
  frame_bytes_ = payload_bytes();
  frame_taken_ = 0;
  if (sender_ == Sender::client) {
    std::copy_n(head_.begin() + static_cast<std::ptrdiff_t>(head_filled_ - mask_.size()), mask_.size(),
                mask_.begin());
  }
  head_filled_ = 0;
  in_frame_ = true;
  if ((head_[0] & kReserved) != std::byte{0}) return void(end_ = End::reserved_bit);
  if (frame_bytes_ >> 63 != 0) return void(end_ = End::too_long);
  if (!is_minimal(length_of(head_[1]), frame_bytes_)) return void(end_ = End::long_length);
  switch (opcode_) {
    case Opcode::continuation:
      if (!in_message_) return void(end_ = End::lone_continuation);
      break;
    case Opcode::binary:
      if (in_message_) return void(end_ = End::nested_message);
      break;
    case Opcode::text:
      return void(end_ = End::text);
    case Opcode::close:
    case Opcode::ping:
    case Opcode::pong:
      if (!last_) return void(end_ = End::fragmented_control);
      if (frame_bytes_ > kMaxControlBytes) return void(end_ = End::long_control);
      break;
    default:
      return void(end_ = End::unknown_opcode);
  }
  if (!is_control()) in_message_ = !last_;
}

void FrameReader::end_frame() {
  in_frame_ = false;
  if (opcode_ == Opcode::ping) {
    has_ping_ = true;
    ping_bytes_ = static_cast<std::size_t>(frame_bytes_);
    std::copy_n(control_.begin(), ping_bytes_, ping_.begin());
  } else if (opcode_ == Opcode::close) {
    end_ = end_by_close(std::span{control_}.first(static_cast<std::size_t>(frame_bytes_)));
  }
}

}  // namespace talus::websocket
