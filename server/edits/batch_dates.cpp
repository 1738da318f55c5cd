#include "edits/batch_dates.h"

#include <algorithm>

namespace talus::server {
namespace {

using std::chrono::duration_cast;
using std::chrono::milliseconds;
using std::chrono::seconds;

}  // namespace

std::int64_t BatchDates::now_ms() {
  const std::chrono::sys_seconds wall = clock_.wall();
  const Clock::time_point now = clock_.uptime();
  const auto expected = believed_ + duration_cast<milliseconds>(now - at_);
  if (wall > expected + kMaxJump) {
    if (!jumped_at_) {
      jumped_at_ = now;
      jumps_ = {jumps_.count + 1, duration_cast<seconds>(wall - expected)};
    }
    if (now - *jumped_at_ < kPatience) return expected.time_since_epoch().count();
  }
  jumped_at_.reset();
  believed_ = wall;
  at_ = now;
  return milliseconds{wall.time_since_epoch()}.count();
}

std::int64_t BatchDates::after(std::int64_t last_ms) {
  const std::int64_t date_ms = now_ms();
  // By the wall clock itself: while a jump is not counted, now_ms() may be behind the last date.
  const milliseconds ahead = milliseconds{last_ms} - clock_.wall().time_since_epoch();
  if (ahead <= kMaxJump) {
    behind_at_.reset();
    return std::max(last_ms, date_ms);
  }
  const Clock::time_point now = clock_.uptime();
  if (!behind_at_) {
    behind_at_ = now;
    jumps_ = {jumps_.count + 1, -duration_cast<seconds>(ahead)};
  }
  return now - *behind_at_ < kPatience ? last_ms : date_ms;
}

}  // namespace talus::server
