// Encodes the client's messages as frames. Pure functions.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <talus/client/client.h>
#include <talus/protocol/message.h>

#include "open_edits.h"
#include "requests.h"

namespace talus::client {

[[nodiscard]] protocol::Frame hello_frame(const Options& options);
/// `known`: held chunks of the View, which are not sent again if unchanged. `has_base`: chunks as generated
/// are not sent.
[[nodiscard]] protocol::Frame view_frame(const View& view, std::uint32_t number,
                                         const std::vector<ReceivedChunk>& known = {}, bool has_base = false);
[[nodiscard]] protocol::Frame heights_frame(std::uint32_t id, const HeightsRequest& request,
                                            const WorldInfo& world);
[[nodiscard]] protocol::Frame file_frame(std::uint32_t id, const FileRequest& request);
[[nodiscard]] protocol::Frame get_chunks_frame(const std::vector<wire::ChunkRequest>& requests);
[[nodiscard]] protocol::Frame cancel_frame(std::span<const std::uint32_t> ids);
[[nodiscard]] protocol::Frame credit_frame(std::uint64_t total_bytes);
[[nodiscard]] protocol::Frame attach_frame(edits::EditorId editor, std::uint64_t seen_revision);
[[nodiscard]] protocol::Frame edit_frame(std::uint32_t id, const OpenEdit& edit);
[[nodiscard]] protocol::Frame ping_frame(std::uint64_t nonce);

[[nodiscard]] wire::ChunkRequest wire_request(std::uint32_t id, const ChunkRequest& request);

/// Maximum number of elements in a frame of `frame_bytes`.
[[nodiscard]] std::size_t chunk_requests_per_frame(std::uint32_t frame_bytes);
[[nodiscard]] std::size_t columns_per_frame(std::uint32_t frame_bytes);
[[nodiscard]] std::size_t known_per_frame(std::uint32_t frame_bytes);

}  // namespace talus::client
