// What the calling thread has had of a core: what others took of it meanwhile does not count.
#pragma once

#include <time.h>

#include <chrono>

namespace talus::server {

[[nodiscard]] inline std::chrono::nanoseconds thread_time() {
  timespec spent{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &spent);
  return std::chrono::seconds{spent.tv_sec} + std::chrono::nanoseconds{spent.tv_nsec};
}

}  // namespace talus::server
