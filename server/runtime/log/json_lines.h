// JSON log lines, one object per line: {"time": RFC 3339 in UTC, "level": ..., "text": ...} plus the fields
// of a LogField.
#pragma once

#include <memory>

#include <spdlog/formatter.h>

namespace talus::server {

class JsonLines final : public spdlog::formatter {
 public:
  void format(const spdlog::details::log_msg& line, spdlog::memory_buf_t& out) override;
  [[nodiscard]] std::unique_ptr<spdlog::formatter> clone() const override;
};

}  // namespace talus::server
