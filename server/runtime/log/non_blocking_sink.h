// A log sink that never blocks the server, however slow the reader or many the lines.
#pragma once

#include <cstdint>
#include <mutex>
#include <string_view>

#include <spdlog/sinks/base_sink.h>

namespace talus::server {

/// Writes lines to a descriptor. A line that the descriptor does not accept at once is dropped, as are info
/// lines of the logger kClientLogger beyond kMaxInfoLinesPerSecond, because clients cause them. The next line
/// written is preceded by a line with the number of dropped lines. Callable from any thread.
class NonBlockingSink final : public spdlog::sinks::base_sink<std::mutex> {
 public:
  static constexpr std::uint32_t kMaxInfoLinesPerSecond = 200;
  static constexpr std::string_view kClientLogger = "clients";

  /// `descriptor` must stay open during the sink's lifetime.
  explicit NonBlockingSink(int descriptor) : descriptor_{descriptor} {}

 private:
  void sink_it_(const spdlog::details::log_msg& message) override;
  void flush_() override {}

  [[nodiscard]] bool within_budget(const spdlog::details::log_msg& message);
  [[nodiscard]] bool write_line(const spdlog::details::log_msg& message);

  int descriptor_;
  spdlog::log_clock::time_point second_{};
  std::uint32_t info_lines_ = 0;  // since second_
  std::uint64_t dropped_ = 0;
};

}  // namespace talus::server
