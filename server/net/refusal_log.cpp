#include "net/refusal_log.h"

#include <utility>

#include <fmt/format.h>

namespace talus::server {

RefusalLog::RefusalLog(Logger log, const Clock& clock) : log_{std::move(log)}, clock_{clock} {}

void RefusalLog::note(const std::string& who, const std::string& why) {
  {
    const std::lock_guard lock{mutex_};
    ++unlogged_;
    last_refused_ = fmt::format("{}: {}", who, why);
  }
  flush();
}

void RefusalLog::flush(Clock::duration since_last_line) {
  const std::lock_guard lock{mutex_};
  const auto now = clock_.now();
  if (unlogged_ == 0) return;
  if (last_line_ != Clock::time_point::min() && now - last_line_ < since_last_line) return;
  last_line_ = now;
  log_->warn("refused {} ({} refused since the last such line)", last_refused_, std::exchange(unlogged_, 0));
}

}  // namespace talus::server
