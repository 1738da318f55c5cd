#include "runtime/log/non_blocking_sink.h"

#include <limits.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <string>

#include <fmt/format.h>

namespace talus::server {

bool NonBlockingSink::within_budget(const spdlog::details::log_msg& message) {
  if (message.level != spdlog::level::info ||
      std::string_view{message.logger_name.data(), message.logger_name.size()} != kClientLogger)
    return true;
  // A clock that was set back begins a second, too: the budget would otherwise stay spent until it has caught
  // up.
  if (message.time < second_ || message.time - second_ >= std::chrono::seconds{1}) {
    second_ = message.time;
    info_lines_ = 0;
  }
  return info_lines_++ < kMaxInfoLinesPerSecond;
}

bool NonBlockingSink::write_line(const spdlog::details::log_msg& message) {
  pollfd writable{descriptor_, POLLOUT, 0};
  if (::poll(&writable, 1, 0) != 1 || (writable.revents & POLLOUT) == 0) return false;
  spdlog::memory_buf_t line;
  formatter_->format(message, line);
  // POSIX: a writable pipe accepts PIPE_BUF bytes atomically.
  if (line.size() > PIPE_BUF) {
    line.resize(PIPE_BUF);
    line[PIPE_BUF - 1] = '\n';
  }
  return ::write(descriptor_, line.data(), line.size()) == static_cast<ssize_t>(line.size());
}

void NonBlockingSink::sink_it_(const spdlog::details::log_msg& message) {
  if (!within_budget(message)) {
    ++dropped_;
    return;
  }
  if (dropped_ > 0) {
    const std::string text = fmt::format("{} log lines were dropped: too many, or read too slowly", dropped_);
    spdlog::details::log_msg notice{message.time, {}, message.logger_name, spdlog::level::warn, text};
    if (write_line(notice)) dropped_ = 0;
  }
  if (!write_line(message)) ++dropped_;
}

}  // namespace talus::server
