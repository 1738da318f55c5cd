// What talusd counts of its work. Every part adds to its own numbers, from any thread; exposition.h says what
// each is called outside.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <talus/protocol/message.h>

#include "access/denial.h"
#include "metrics/tally.h"
#include "rates/rate_kind.h"

namespace talus::server {

/// Why a connection was turned away before it had a session.
enum class Refusal : std::uint8_t {
  places,      // of connections, in all or from its address
  memory,      // is all in use
  pace,        // its address begins them too fast
  handshakes,  // too many under way
  proxy,       // a proxy that does not say for whom it speaks
};
inline constexpr std::size_t kRefusals = 5;

struct Metrics {
  // ---- connections
  Counter accepted;
  std::array<Counter, kRefusals> refused;
  Level handshakes;        // of proxies and of TLS, under way
  Counter tls_handshakes;  // done
  Counter tls_failed;
  Counter tls_late;
  Level open;
  Level greeted;  // of those open
  Counter received_bytes;
  Counter sent_bytes;

  // ---- what clients are told
  std::array<Counter, static_cast<std::size_t>(wire::ErrorCode::MAX) + 1> errors;
  std::array<Counter, kDenials> tokens_denied;
  Counter chunks_sent;
  Counter columns_sent;
  Counter unchanged_sent;
  Counter chunk_bytes_sent;  // of their frames

  /// From when a session takes up a wish for a chunk to when the chunk is ready to go: with the chunk at
  /// hand (those of one turn together: they go together), or waiting for a generator. How long the client's
  /// link then takes is not the server's.
  LatencyTally hot_latency;
  LatencyTally cold_latency;

  // ---- where chunks come from
  Counter cache_hits;
  Counter cache_misses;
  Counter uniform_answers;  // known without looking
  Counter patches_made;
  Counter patch_ns;
  Counter chunks_made;
  Counter chunk_ns;
  Counter heights_made;  // columns
  Counter heights_ns;
  Counter jobs_refused;
  Counter jobs_cancelled;  // the last who waited left

  /// How often a rate refused a request or made chunks wait.
  std::array<Counter, kRateNames.size()> rates_held;

  Counter& held(RateKind kind) { return rates_held[static_cast<std::size_t>(kind)]; }
  Counter& denied(Denial denial) { return tokens_denied[static_cast<std::size_t>(denial)]; }
  Counter& refused_for(Refusal why) { return refused[static_cast<std::size_t>(why)]; }
  Counter& error(wire::ErrorCode code) { return errors[static_cast<std::size_t>(code)]; }
};

}  // namespace talus::server
