// The seed of a test's random numbers.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>

/// TALUS_SEED, which repeats a run, or a random one.
inline std::uint64_t seed_of_run() {
  const char* const given = std::getenv("TALUS_SEED");
  return given != nullptr ? std::stoull(given) : std::random_device{}();
}
