// Metrics as the text that Prometheus reads.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "memory/memory_budget.h"
#include "metrics/metrics.h"
#include "metrics/process.h"

namespace talus::server {

/// What is asked of other parts when somebody looks.
struct Depths {
  std::uint64_t jobs = 0;             // chunks that wait for a generator, or are in one
  std::uint64_t waiting_clients = 0;  // who have something waiting
  std::uint64_t chunk_cache_bytes = 0;
  std::uint64_t patch_cache_bytes = 0;
  bool draining = false;
  std::array<std::uint64_t, kMemoryUses.size()> memory_bytes{};
  std::uint64_t memory_limit_bytes = 0;  // 0: none
  std::int64_t certificate_expires = 0;  // seconds since 1970; 0: no TLS
};

/// What never changes while a server runs.
struct BuildInfo {
  std::string version;
  std::uint64_t generator = 0;
  std::string fingerprint;
  std::string instruction_set;
};

[[nodiscard]] std::string prometheus_text(const Metrics& metrics, const Depths& depths,
                                          const ProcessReading& process, const BuildInfo& build);

}  // namespace talus::server
