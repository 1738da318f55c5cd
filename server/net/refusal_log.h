// One line a second about refused connections, however many there are. Callable from any thread.
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
  /// Logs how many were refused and which one last, where that is not logged yet and the line before is at
  /// least so old.
  void flush(Clock::duration since_last_line = std::chrono::seconds{1});

 private:
  Logger log_;
  const Clock& clock_;
  std::mutex mutex_;
  Clock::time_point last_line_ = Clock::time_point::min();
  std::uint64_t unlogged_ = 0;
  std::string last_refused_;  // who, and why
};

}  // namespace talus::server
