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
  const Clock::time_point now = clock_.now();
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
  const milliseconds ahead{last_ms - date_ms};
  if (ahead <= kMaxJump) return std::max(last_ms, date_ms);
  jumps_ = {jumps_.count + 1, -duration_cast<seconds>(ahead)};
  return date_ms;
}

}  // namespace talus::server
