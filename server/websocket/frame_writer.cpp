#include "websocket/frame_writer.h"

#include <cassert>

namespace talus::server::websocket {
namespace {

constexpr std::byte kFinalBinary{0x82};
constexpr std::byte kFinalClose{0x88};
constexpr std::byte kFinalPong{0x8A};
constexpr std::byte kTwoByteLength{126};    // two bytes of length follow
constexpr std::byte kEightByteLength{127};  // eight

}  // namespace

std::size_t write_head(std::span<std::byte, kMaxHeadBytes> head, std::uint64_t payload_bytes) {
  head[0] = kFinalBinary;
  const std::size_t wide = payload_bytes < std::to_integer<std::uint64_t>(kTwoByteLength) ? 0
                           : payload_bytes <= 0xFFFF                                      ? 2
                                                                                          : 8;
  head[1] = wide == 0 ? static_cast<std::byte>(payload_bytes) : wide == 2 ? kTwoByteLength : kEightByteLength;
  for (std::size_t i = 0; i < wide; ++i) {
    head[2 + i] = static_cast<std::byte>(payload_bytes >> (8 * (wide - 1 - i)));
  }
  return 2 + wide;
}

void append_pong(std::vector<std::byte>& output, std::span<const std::byte> payload) {
  assert(payload.size() <= FrameReader::kMaxControlBytes);
  output.push_back(kFinalPong);
  output.push_back(static_cast<std::byte>(payload.size()));
  output.insert(output.end(), payload.begin(), payload.end());
}

void append_close(std::vector<std::byte>& output, CloseCode code) {
  const auto number = static_cast<std::uint16_t>(code);
  output.insert(output.end(), {kFinalClose, std::byte{2}, static_cast<std::byte>(number >> 8),
                               static_cast<std::byte>(number)});
}

}  // namespace talus::server::websocket
