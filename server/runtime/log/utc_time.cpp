#include "runtime/log/utc_time.h"

#include <array>
#include <ctime>

namespace talus::server {

std::string utc_time(std::chrono::sys_seconds time, const char* format) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(time);
  std::tm broken_down{};
  std::array<char, 64> text{};
  ::gmtime_r(&seconds, &broken_down);
  return {text.data(), std::strftime(text.data(), text.size(), format, &broken_down)};
}

}  // namespace talus::server
