// Text log lines: time, level, text. Escapes control characters of all lines.
#pragma once

#include <memory>

#include <spdlog/formatter.h>
#include <spdlog/pattern_formatter.h>

namespace talus::server {

class TextLines final : public spdlog::formatter {
 public:
  void format(const spdlog::details::log_msg& line, spdlog::memory_buf_t& out) override;
  [[nodiscard]] std::unique_ptr<spdlog::formatter> clone() const override;

 private:
  spdlog::pattern_formatter plain_{"%Y-%m-%dT%H:%M:%S.%e%z %l %v"};
};

}  // namespace talus::server
