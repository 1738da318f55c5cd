// All results of a run.
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
  double seconds = 0;  // since the players started
  std::uint64_t chunks = 0, uniform = 0, bytes = 0, edits = 0;
  double harness_cpu_seconds = 0;
  ServerSample server;
};

struct RunResult {
  Tallies tallies;
  measure::Histogram lateness;         // the harness's own
  ServerSample before, after;          // before the first client; after all have left
  ServerSample idle;                   // with the idle connections, before the players
  Moment begin, end;                   // bounds of the measured time
  std::vector<double> resident_bytes;  // the server's, measured about once per second
  std::uint64_t idle_joined = 0;
  std::map<std::string, RateModel> rates;  // advertised by the server, by the names of its settings
  bool interrupted = false;

  /// Increase of resident memory from the first to the last tenth of the measured time, by the mean of each,
  /// because allocators make it vary from second to second.
  [[nodiscard]] std::optional<double> resident_growth_percent() const;

  /// The server's rates that delayed players for more than a twentieth of the measured time.
  [[nodiscard]] std::map<std::string, RateModel> held_by() const;

  /// Tally of the players only; all() merges all roles.
  [[nodiscard]] Tally players() const;
  [[nodiscard]] Tally all() const;
};

}  // namespace talus::load
