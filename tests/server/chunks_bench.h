// Shared by the tests of Chunks.
#pragma once

#include <cstdint>

#include "chunks/chunks.h"
#include "fake_generator.h"

namespace talus::server::chunks_test {

constexpr std::uint64_t kMebibyte = 1U << 20;

inline ChunkKey at(std::int32_t x) {
  return {{x, 0, 0}, Lod{}};
}

inline bool queued(ChunkSource& chunks, const MailboxPtr& mailbox, ChunkKey key) {
  return chunks.submit(mailbox, {&key, 1}, Urgency::later, Version::generated) == 1;
}
inline bool queued(ChunkSource& chunks, const WaitingClient& client, ChunkKey key) {
  return queued(chunks, client.mailbox(), key);
}

inline void cancel(ChunkSource& chunks, const WaitingClient& client, ChunkKey key) {
  chunks.cancel(client.id(), {&key, 1});
}

}  // namespace talus::server::chunks_test
