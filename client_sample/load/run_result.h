// Everything that a run found.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "plan.h"
#include "rate_model.h"
#include "server_watch.h"
#include "tally.h"

namespace talus::load {

/// Totals at one moment.
struct Moment {
  double seconds = 0;  // since the players began
  std::uint64_t chunks = 0, uniform = 0, bytes = 0, edits = 0;
  double harness_cpu_seconds = 0;
  ServerSample server;
};

struct RunResult {
  Tallies tallies;
  measure::Histogram lateness;         // of the harness itself
  ServerSample before, after;          // before the first client; when all had left
  ServerSample idle;                   // with the idle connections, before the players
  Moment begin, end;                   // of what is measured
  std::vector<double> resident_bytes;  // the server's, about once a second of it
  std::uint64_t idle_joined = 0;
  std::map<std::string, RateModel> rates;  // that the server told, by the names of its settings
  bool interrupted = false;

  /// How much more was resident in the last tenth of the measured time than in the first, means of each: from
  /// one second to the next it goes up and down by what an allocator keeps.
  [[nodiscard]] std::optional<double> resident_growth_percent() const;

  /// Those of the server's rates that held the players for more than a twentieth of the measured time.
  [[nodiscard]] std::map<std::string, RateModel> held_by() const;

  /// The players' alone, and everybody's.
  [[nodiscard]] Tally players() const;
  [[nodiscard]] Tally all() const;
};

}  // namespace talus::load
