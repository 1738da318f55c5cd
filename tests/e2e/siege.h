// What tests of a server under attack share.
#pragma once

#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <cstdlib>

namespace talus::e2e {

/// How long a siege takes: TALUS_HOSTILE_SECONDS; 10 s by default, 600 s for the long version.
inline std::chrono::seconds siege_time() {
  const char* seconds = std::getenv("TALUS_HOSTILE_SECONDS");
  return std::chrono::seconds{seconds == nullptr ? 10 : std::atoi(seconds)};
}

/// Lets this process hold as many sockets as the system allows it.
inline void allow_many_sockets() {
  rlimit files{};
  REQUIRE(::getrlimit(RLIMIT_NOFILE, &files) == 0);
  files.rlim_cur = files.rlim_max;
  REQUIRE(::setrlimit(RLIMIT_NOFILE, &files) == 0);
}

}  // namespace talus::e2e
