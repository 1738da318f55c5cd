// The control frames that the server sends: everything but Chunk. Pure functions.
#pragma once

#include <chrono>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <talus/protocol/message.h>
#include <talus/voxel/coords.h>

#include "chunks/chunk_change.h"
#include "chunks/edit_answers.h"
#include "chunks/encoded_chunk.h"
#include "chunks/heights_query.h"
#include "limits/rates/rates.h"
#include "player/session/handshake.h"
#include "player/session/retry_after.h"
#include "player/session/session_limits.h"
#include "player/session/subject.h"
#include "player/session/world_info.h"

namespace talus::server {

[[nodiscard]] protocol::Frame welcome_frame(const Greeting& greeting, const WorldInfo& world,
                                            const SessionLimits& limits, const RateLimits& rates);
[[nodiscard]] protocol::Frame error_frame(wire::ErrorCode code, std::string_view text,
                                          const Subject& subject = {},
                                          std::chrono::milliseconds retry_after = retry_after::kNever);
/// `request_id` 0: for the View.
[[nodiscard]] protocol::Frame unchanged_frame(std::uint32_t request_id, ChunkKey key,
                                              const EncodedChunk& chunk);
/// For a client whose revision of the chunk is between `previous` and the revision of `changed`.
[[nodiscard]] protocol::Frame edit_broadcast_frame(ChunkKey key, std::uint64_t previous,
                                                   const ChangedVoxels& changed);
/// In answer to a request; `request_id` is not 0.
[[nodiscard]] protocol::Frame chunk_frame(std::uint32_t request_id, ChunkKey key, const EncodedChunk& chunk);
/// `column` is any chunk of the column.
[[nodiscard]] protocol::Frame column_frame(ChunkKey column, const std::vector<wire::UniformRun>& runs);
[[nodiscard]] protocol::Frame view_complete_frame(std::uint32_t number);
[[nodiscard]] protocol::Frame heights_frame(std::uint32_t request_id, const HeightsResult& found);
/// `size` is the whole file's.
[[nodiscard]] protocol::Frame file_part_frame(std::uint32_t request_id, std::uint64_t size,
                                              std::string_view bytes);
[[nodiscard]] protocol::Frame attached_frame(const EditorSession& editor, std::uint64_t voxels_per_second);
[[nodiscard]] protocol::Frame edit_result_frame(std::uint32_t request_id, const edits::EditResult& result);
[[nodiscard]] protocol::Frame pong_frame(std::uint64_t nonce);
[[nodiscard]] protocol::Frame go_away_frame(std::string_view reason, std::chrono::milliseconds retry_after);

}  // namespace talus::server
