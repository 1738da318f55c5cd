// Everything but Chunk that the server says, as frames.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <talus/protocol/message.h>
#include <talus/voxel/coords.h>

#include "config/config.h"
#include "session/handshake.h"
#include "session/world_info.h"

namespace talus::server {

[[nodiscard]] protocol::Frame welcome_frame(const Greeting& greeting, const WorldInfo& world,
                                            const Limits& limits);
/// Why new work is refused near limits.memory_bytes.
inline constexpr std::string_view kNoMemory = "this server's memory is all in use";

/// `request_id` 0: not about a request. `retry_after_ms` 0: retrying does not help.
[[nodiscard]] protocol::Frame error_frame(wire::ErrorCode code, std::string_view text,
                                          std::uint32_t request_id = 0, std::uint32_t retry_after_ms = 0);
[[nodiscard]] protocol::Frame unchanged_frame(std::uint32_t request_id, ChunkKey key, ContentHash hash);
[[nodiscard]] protocol::Frame column_frame(ChunkKey column, const std::vector<wire::UniformRun>& runs);
[[nodiscard]] protocol::Frame heights_frame(std::uint32_t request_id, std::span<const std::int32_t> heights);
[[nodiscard]] protocol::Frame pong_frame(std::uint64_t nonce);
[[nodiscard]] protocol::Frame go_away_frame(std::string_view reason, std::uint32_t retry_after_ms);

}  // namespace talus::server
