// Writes WebSocket frames of either side. No I/O. Source: RFC 6455, section 5.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <talus/websocket/frame_reader.h>

namespace talus::websocket {

/// Maximum header of an unmasked frame.
inline constexpr std::size_t kMaxHeadBytes = 10;

/// Writes the header of a server's unfragmented binary message; returns its length.
std::size_t write_head(std::span<std::byte, kMaxHeadBytes> head, std::uint64_t payload_bytes);

/// Mask of a client's frame (section 5.3): random per frame and unpredictable, or the author of the payload
/// could choose the bytes that proxies on the way see. Empty: a server's frame.
using Mask = std::optional<std::array<std::byte, 4>>;

/// Appends an unfragmented binary message.
void append_binary(std::vector<std::byte>& output, std::span<const std::byte> payload, const Mask& mask);
/// Appends a Pong. `payload`: the Ping's, at most FrameReader::kMaxControlBytes.
void append_pong(std::vector<std::byte>& output, std::span<const std::byte> payload, const Mask& mask = {});
/// Appends a Close.
void append_close(std::vector<std::byte>& output, CloseCode code, const Mask& mask = {});

}  // namespace talus::websocket
