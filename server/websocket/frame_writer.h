// The frames that a WebSocket server sends. No I/O. Source: RFC 6455, section 5.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "websocket/frame_reader.h"

namespace talus::server::websocket {

/// Of frames to a client, which are not masked.
inline constexpr std::size_t kMaxHeadBytes = 10;

/// The head of a binary message in one frame; returns how long it is.
std::size_t write_head(std::span<std::byte, kMaxHeadBytes> head, std::uint64_t payload_bytes);

/// A whole Pong. `payload`: the Ping's, at most FrameReader::kMaxControlBytes.
void append_pong(std::vector<std::byte>& output, std::span<const std::byte> payload);
/// A whole Close.
void append_close(std::vector<std::byte>& output, CloseCode code);

}  // namespace talus::server::websocket
