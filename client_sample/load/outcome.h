// Everything that a run found.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "plan.h"
#include "server_watch.h"
#include "tally.h"

namespace talus::load {

/// Totals at one moment.
struct Moment {
  double seconds = 0;  // since the players began
  std::uint64_t chunks = 0, uniform = 0, bytes = 0;
  double harness_cpu_seconds = 0;
  ServerSample server;
};

struct Outcome {
  Tallies tallies;
  Histogram lateness;          // of the harness itself
  ServerSample before, after;  // before the first client; when all had left
  ServerSample idle;           // with the idle connections, before the players
  Moment begin, end;           // of what is measured
  std::uint64_t idle_joined = 0;
  bool interrupted = false;

  /// The players' alone, and everybody's.
  [[nodiscard]] Tally players() const;
  [[nodiscard]] Tally all() const;
};

}  // namespace talus::load
