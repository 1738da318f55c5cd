// The frames that either end of a WebSocket sends. No I/O. Source: RFC 6455, section 5.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <talus/websocket/frame_reader.h>

namespace talus::websocket {

/// Of a frame that is not masked.
inline constexpr std::size_t kMaxHeadBytes = 10;

/// The head of a server's binary message in one frame; returns how long it is.
std::size_t write_head(std::span<std::byte, kMaxHeadBytes> head, std::uint64_t payload_bytes);

/// What a client masks a frame with (section 5.3): random for each frame, and not to be foretold, or who
/// chooses the payload would choose the bytes that proxies on the way see. Empty: a server's frame.
using Mask = std::optional<std::array<std::byte, 4>>;

/// A whole binary message.
void append_binary(std::vector<std::byte>& output, std::span<const std::byte> payload, const Mask& mask);
/// A whole Pong. `payload`: the Ping's, at most FrameReader::kMaxControlBytes.
void append_pong(std::vector<std::byte>& output, std::span<const std::byte> payload, const Mask& mask = {});
/// A whole Close.
void append_close(std::vector<std::byte>& output, CloseCode code, const Mask& mask = {});

}  // namespace talus::websocket
