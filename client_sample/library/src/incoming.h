// Converts the server's messages to trusted values. Pure functions of verified messages.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <talus/client/error.h>
#include <talus/client/received_chunk.h>
#include <talus/client/world_info.h>
#include <talus/protocol/message.h>

namespace talus::client {

/// ErrorKind::broken_protocol; `what` describes the violation.
[[nodiscard]] ClientError broken_protocol(std::string what);

[[nodiscard]] Result<WorldInfo> read_welcome(const wire::Welcome& welcome);

/// Fails unless the coordinate is inside the world and its level exists.
[[nodiscard]] Result<ChunkKey> read_key(const wire::ChunkKey* key);

/// The voxels of `edit`; ErrorKind::broken_protocol if its runs are invalid. `key` is for the message.
[[nodiscard]] Result<std::vector<Override>> read_runs(const ChunkKey& key, const wire::EditBroadcast& edit);

/// Applies `edit`, made for this revision, to `chunk`; ErrorKind::broken_protocol if its runs are invalid.
[[nodiscard]] Result<ReceivedChunk> read_broadcast(const ReceivedChunk& chunk,
                                                   const wire::EditBroadcast& edit);

/// Decodes the payload and checks its hash; ErrorKind::bad_chunk if that fails.
[[nodiscard]] Result<ReceivedChunk> read_chunk(ChunkKey key, const wire::Chunk& message);

[[nodiscard]] ContentHash read_hash(const wire::Hash128* hash);
[[nodiscard]] ClientError read_error(const wire::Error& error);

/// Converts a server's text to one printable UTF-8 line of bounded length.
[[nodiscard]] std::string read_text(const flatbuffers::String* text);

}  // namespace talus::client
