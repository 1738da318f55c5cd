#include "runtime/log/logger.h"

#include <unistd.h>

#include <exception>

#include <fmt/format.h>
#include <spdlog/logger.h>

#include "runtime/log/json_lines.h"
#include "runtime/log/non_blocking_sink.h"
#include "runtime/log/spdlog_level.h"
#include "runtime/log/text_lines.h"

namespace talus::server {
namespace {

class SpdLog final : public LogWriter {
 public:
  explicit SpdLog(std::shared_ptr<spdlog::logger> lines) : lines_{std::move(lines)} {}

  void write(LogLevel level, std::string_view text, const LogField& field) override {
    // spdlog passes a line's source location to its formatter, on the logging thread.
    const auto location =
        field.name == nullptr ? spdlog::source_loc{} : spdlog::source_loc{field.name, 1, field.json.c_str()};
    lines_->log(location, spdlog_level(level), spdlog::string_view_t{text.data(), text.size()});
  }
  [[nodiscard]] bool is_enabled(LogLevel level) const override {
    return lines_->should_log(spdlog_level(level));
  }
  [[nodiscard]] Logger clone(std::string_view name) const {
    return std::make_shared<SpdLog>(lines_->clone(std::string{name}));
  }

 private:
  std::shared_ptr<spdlog::logger> lines_;
};

}  // namespace

void LogWriter::format(LogLevel level, fmt::string_view text, fmt::format_args values) {
  if (!is_enabled(level)) return;
  try {
    fmt::memory_buffer line;
    fmt::vformat_to(fmt::appender{line}, text, values);
    write(level, {line.data(), line.size()});
  } catch (const std::exception&) {  // no memory
  }
}

Logger make_logger(std::string_view level, std::string_view format) {
  auto lines = std::make_shared<spdlog::logger>("talusd", std::make_shared<NonBlockingSink>(STDOUT_FILENO));
  if (format == "json") {
    lines->set_formatter(std::make_unique<JsonLines>());
  } else {
    lines->set_formatter(std::make_unique<TextLines>());
  }
  lines->set_level(spdlog::level::from_str(std::string{level}));
  return std::make_shared<SpdLog>(std::move(lines));
}

Logger for_clients(const Logger& log) {
  const auto* const lines = dynamic_cast<const SpdLog*>(log.get());
  return lines == nullptr ? log : lines->clone(NonBlockingSink::kClientLogger);
}

}  // namespace talus::server
