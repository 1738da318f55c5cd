// From what a server sent to values that can be trusted. Pure functions over verified messages.
#pragma once

#include <span>
#include <string>

#include <talus/client/error.h>
#include <talus/client/received_chunk.h>
#include <talus/client/world_info.h>
#include <talus/protocol/message.h>

namespace talus::client {

/// ErrorKind::broken_protocol with a line that says what the server did.
[[nodiscard]] ClientError broken_protocol(std::string what);

[[nodiscard]] Result<WorldInfo> read_welcome(const wire::Welcome& welcome);

/// A coordinate inside the world, at a level that exists.
[[nodiscard]] Result<ChunkKey> read_key(const wire::ChunkKey* key);

/// `chunk` after `edit`, which applies to its revision; ErrorKind::broken_protocol where its runs are none.
[[nodiscard]] Result<ReceivedChunk> read_broadcast(const ReceivedChunk& chunk,
                                                   const wire::EditBroadcast& edit);

/// Decodes the payload and compares the content with its hash; ErrorKind::bad_chunk where that fails.
[[nodiscard]] Result<ReceivedChunk> read_chunk(ChunkKey key, const wire::Chunk& message);

[[nodiscard]] ContentHash read_hash(const wire::Hash128* hash);
[[nodiscard]] ClientError read_error(const wire::Error& error);

/// A server's text as one printable line of bounded length, in UTF-8.
[[nodiscard]] std::string read_text(const flatbuffers::String* text);

}  // namespace talus::client
