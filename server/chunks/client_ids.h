// Ids of those who wait for chunks. Each kind has a range of its own: of two with one id the generators would
// answer only one.
#pragma once

#include <cassert>
#include <cstdint>

#include "chunks/mailbox.h"

namespace talus::server {

enum class ClientKind : std::uint8_t {
  session,   // by its connection's number, as it is
  look_ups,  // of a session's edits, by the same number
  fetch,     // over HTTP
  pregen,
};

/// REQUIRES: `number` is below 2^62, and new among those of its kind.
[[nodiscard]] constexpr ClientId client_id(ClientKind kind, std::uint64_t number) {
  assert(number >> 62U == 0);
  return ClientId{(static_cast<std::uint64_t>(kind) << 62U) | number};
}

}  // namespace talus::server
