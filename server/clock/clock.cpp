#include "clock/clock.h"

#include <ctime>

namespace talus::server {

Clock::time_point SystemClock::now() const {
  return std::chrono::steady_clock::now();
}

std::chrono::sys_seconds SystemClock::wall() const {
  return std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
}

std::chrono::nanoseconds SystemClock::thread_cpu() const {
  timespec used{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return std::chrono::seconds{used.tv_sec} + std::chrono::nanoseconds{used.tv_nsec};
}

}  // namespace talus::server
