// A WebSocket's frames as a client sends and reads them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace talus::server {

inline void append_client_frame(std::vector<std::byte>& output, int opcode,
                                std::span<const std::byte> payload, std::uint32_t mask, bool last = true) {
  const auto put = [&](std::uint64_t value, int bytes) {
    for (int i = bytes - 1; i >= 0; --i) output.push_back(static_cast<std::byte>(value >> (8 * i)));
  };
  put((last ? 0x80U : 0U) | static_cast<unsigned>(opcode), 1);
  if (payload.size() < 126) {
    put(0x80 | payload.size(), 1);
  } else if (payload.size() <= 0xFFFF) {
    put(0x80 | 126, 1);
    put(payload.size(), 2);
  } else {
    put(0x80 | 127, 1);
    put(payload.size(), 8);
  }
  put(mask, 4);
  for (std::size_t i = 0; i < payload.size(); ++i) {
    output.push_back(payload[i] ^ static_cast<std::byte>(mask >> (8 * (3 - i % 4))));
  }
}

/// What a server sent.
struct ServerFrames {
  std::string payload;  // of all binary frames
  std::vector<std::string> pongs;
  std::optional<int> close;  // its code
  bool whole = true;         // every frame is
  std::size_t bytes = 0;     // of whole frames
};
inline ServerFrames read_server_frames(std::span<const std::byte> bytes) {
  ServerFrames all;
  const auto number = [&](std::size_t at, std::size_t count) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < count; ++i)
      value = value << 8 | std::to_integer<std::uint64_t>(bytes[at + i]);
    return value;
  };
  while (all.bytes < bytes.size()) {
    const std::size_t at = all.bytes;
    all.whole = false;
    if (bytes.size() - at < 2) return all;
    const std::uint64_t short_length = number(at + 1, 1);  // not masked
    const std::size_t wide = short_length < 126 ? 0 : short_length == 126 ? 2 : 8;
    if (bytes.size() - at < 2 + wide) return all;
    const std::uint64_t length = wide == 0 ? short_length : number(at + 2, wide);
    if (bytes.size() - at - 2 - wide < length) return all;
    const std::string text{reinterpret_cast<const char*>(bytes.data()) + at + 2 + wide,
                           static_cast<std::size_t>(length)};
    const std::uint64_t first = number(at, 1);
    if (first == 0x82) all.payload += text;
    if (first == 0x8A) all.pongs.push_back(text);
    if (first == 0x88) all.close = static_cast<int>(number(at + 2, 2));
    all.bytes = at + 2 + wide + static_cast<std::size_t>(length);
    all.whole = true;
  }
  return all;
}

}  // namespace talus::server
