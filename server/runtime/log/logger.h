// The server's log on stdout. main creates it once and passes it down.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/core.h>

namespace talus::server {

enum class LogLevel : std::uint8_t { debug, info, warn, error };

/// A JSON object that follows a line's text as the member `name` if the format is JSON. Text lines omit it.
struct LogField {
  const char* name = nullptr;  // null: no field
  std::string json{};
};

/// A log of lines. Callable from any thread. No call throws; a line for which memory is missing is dropped.
class LogWriter {
 public:
  LogWriter() = default;
  virtual ~LogWriter() = default;
  LogWriter(const LogWriter&) = delete;
  LogWriter& operator=(const LogWriter&) = delete;

  template <class... Values>
  void debug(fmt::format_string<Values...> text, Values&&... values) {
    log(LogLevel::debug, text, std::forward<Values>(values)...);
  }
  template <class... Values>
  void info(fmt::format_string<Values...> text, Values&&... values) {
    log(LogLevel::info, text, std::forward<Values>(values)...);
  }
  template <class... Values>
  void warn(fmt::format_string<Values...> text, Values&&... values) {
    log(LogLevel::warn, text, std::forward<Values>(values)...);
  }
  template <class... Values>
  void error(fmt::format_string<Values...> text, Values&&... values) {
    log(LogLevel::error, text, std::forward<Values>(values)...);
  }
  template <class... Values>
  void log(LogLevel level, fmt::format_string<Values...> text, Values&&... values) {
    format(level, text, fmt::make_format_args(values...));
  }

  /// Writes a line if `level` is enabled.
  virtual void write(LogLevel level, std::string_view text, const LogField& field = {}) = 0;
  [[nodiscard]] virtual bool is_enabled(LogLevel level) const = 0;

 private:
  void format(LogLevel level, fmt::string_view text, fmt::format_args values);
};

using Logger = std::shared_ptr<LogWriter>;

/// `level` is trace, debug, info, warning, error or off; `format` is text or json. Config validates both.
[[nodiscard]] Logger make_logger(std::string_view level, std::string_view format);
/// The same log for lines that clients cause: its info lines per second are limited, if it is of
/// make_logger().
[[nodiscard]] Logger for_clients(const Logger& log);

}  // namespace talus::server
