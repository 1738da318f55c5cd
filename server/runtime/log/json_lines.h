// Log lines as JSON objects, one a line: {"time": RFC 3339 in UTC, "level": ..., "text": ...},
// and what log_with_fields() adds.
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
