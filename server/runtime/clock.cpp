#include "runtime/clock.h"

#include <ctime>

namespace talus::server {

Clock::time_point SystemClock::now() const {
  return std::chrono::steady_clock::now();
}

Clock::time_point SystemClock::uptime() const {
  timespec now{};
  if (::clock_gettime(CLOCK_BOOTTIME, &now) != 0) return this->now();
  return time_point{std::chrono::seconds{now.tv_sec} + std::chrono::nanoseconds{now.tv_nsec}};
}

std::chrono::sys_seconds SystemClock::wall() const {
  // The coarse clock lags by a few ms at most and costs a quarter: every HTTP answer carries the date.
  timespec now{};
  ::clock_gettime(CLOCK_REALTIME_COARSE, &now);
  return std::chrono::sys_seconds{std::chrono::seconds{now.tv_sec}};
}

std::chrono::nanoseconds SystemClock::thread_cpu() const {
  timespec used{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return std::chrono::seconds{used.tv_sec} + std::chrono::nanoseconds{used.tv_nsec};
}

}  // namespace talus::server
