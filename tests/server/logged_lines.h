// A log whose lines a test reads.
#pragma once

#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>

#include "runtime/log/logger.h"

namespace talus::server {

class LoggedLines final : public LogWriter {
 public:
  void write(LogLevel /*level*/, std::string_view text, const LogField& /*field*/) override {
    const std::lock_guard lock{mutex_};
    text_.append(text) += '\n';
    ++count_;
  }
  [[nodiscard]] bool is_enabled(LogLevel /*level*/) const override { return true; }

  /// The texts of all lines, each with its newline.
  [[nodiscard]] std::string text() const {
    const std::lock_guard lock{mutex_};
    return text_;
  }
  [[nodiscard]] std::size_t count() const {
    const std::lock_guard lock{mutex_};
    return count_;
  }

 private:
  mutable std::mutex mutex_;
  std::string text_;
  std::size_t count_ = 0;
};

}  // namespace talus::server
