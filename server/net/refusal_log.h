// Logs refused connections in at most one line a second. Callable from any thread.
#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

#include "runtime/clock.h"
#include "runtime/log/logger.h"

namespace talus::server {

class RefusalLog {
 public:
  /// `clock` outlives it.
  RefusalLog(Logger log, const Clock& clock);

  void note(const std::string& who, const std::string& why);
  /// Logs the number of refusals and the last of them if there are unlogged ones and the previous line is at
  /// least `since_last_line` old.
  void flush(Clock::duration since_last_line = std::chrono::seconds{1});

 private:
  Logger log_;
  const Clock& clock_;
  std::mutex mutex_;
  Clock::time_point last_line_ = Clock::time_point::min();
  std::uint64_t unlogged_ = 0;
  std::string last_refused_;  // address and reason
};

}  // namespace talus::server
