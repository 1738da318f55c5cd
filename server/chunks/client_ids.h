// Ids of clients that wait for chunks. Each kind has its own range: of two clients with the same id the
// generators would answer only one.
#pragma once

#include <cassert>
#include <cstdint>

#include "chunks/mailbox.h"

namespace talus::server {

enum class ClientKind : std::uint8_t {
  session,   // the connection's number itself
  look_ups,  // look-ups of a session's edits, by the same number
  fetch,     // over HTTP
  pregen,
};

/// REQUIRES: `number` is below 2^62 and unique within its kind.
[[nodiscard]] constexpr ClientId client_id(ClientKind kind, std::uint64_t number) {
  assert(number >> 62U == 0);
  return ClientId{(static_cast<std::uint64_t>(kind) << 62U) | number};
}

}  // namespace talus::server
