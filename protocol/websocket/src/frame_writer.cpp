#include <talus/websocket/frame_writer.h>

#include <algorithm>
#include <cassert>

namespace talus::websocket {
namespace {

constexpr std::byte kFinalBinary{0x82};
constexpr std::byte kFinalClose{0x88};
constexpr std::byte kFinalPong{0x8A};
constexpr std::byte kMaskFollows{0x80};
constexpr std::byte kTwoByteLength{126};    // two bytes of length follow
constexpr std::byte kEightByteLength{127};  // eight bytes of length follow

std::size_t write_head(std::span<std::byte, kMaxHeadBytes> head, std::byte first,
                       std::uint64_t payload_bytes) {
  head[0] = first;
  const std::size_t wide = payload_bytes < std::to_integer<std::uint64_t>(kTwoByteLength) ? 0
                           : payload_bytes <= 0xFFFF                                      ? 2
                                                                                          : 8;
  head[1] = wide == 0 ? static_cast<std::byte>(payload_bytes) : wide == 2 ? kTwoByteLength : kEightByteLength;
  for (std::size_t i = 0; i < wide; ++i) {
    head[2 + i] = static_cast<std::byte>(payload_bytes >> (8 * (wide - 1 - i)));
  }
  return 2 + wide;
}

void append_frame(std::vector<std::byte>& output, std::byte first, std::span<const std::byte> payload,
                  const Mask& mask) {
  std::array<std::byte, kMaxHeadBytes> head{};
  const std::size_t head_bytes = write_head(head, first, payload.size());
  if (mask) head[1] |= kMaskFollows;
  output.reserve(output.size() + head_bytes + (mask ? mask->size() : 0) + payload.size());
  output.insert(output.end(), head.begin(), head.begin() + static_cast<std::ptrdiff_t>(head_bytes));
  if (mask) output.insert(output.end(), mask->begin(), mask->end());
  const std::size_t begin = output.size();
  output.insert(output.end(), payload.begin(), payload.end());
  for (std::size_t i = 0; mask && i < payload.size(); ++i) output[begin + i] ^= (*mask)[i % mask->size()];
}

}  // namespace

std::size_t write_head(std::span<std::byte, kMaxHeadBytes> head, std::uint64_t payload_bytes) {
  return write_head(head, kFinalBinary, payload_bytes);
}

void append_binary(std::vector<std::byte>& output, std::span<const std::byte> payload, const Mask& mask) {
  append_frame(output, kFinalBinary, payload, mask);
}

void append_pong(std::vector<std::byte>& output, std::span<const std::byte> payload, const Mask& mask) {
  assert(payload.size() <= FrameReader::kMaxControlBytes);
  append_frame(output, kFinalPong, payload, mask);
}

void append_close(std::vector<std::byte>& output, CloseCode code, const Mask& mask) {
  const auto number = static_cast<std::uint16_t>(code);
  const std::array payload{static_cast<std::byte>(number >> 8), static_cast<std::byte>(number)};
  append_frame(output, kFinalClose, payload, mask);
}

}  // namespace talus::websocket
