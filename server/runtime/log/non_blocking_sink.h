// A log sink that never blocks the server, whoever reads the log and however many lines clients cause.
#pragma once

#include <cstdint>
#include <mutex>
#include <string_view>

#include <spdlog/sinks/base_sink.h>

namespace talus::server {

/// Writes lines to a descriptor. A line that the descriptor does not take at once is dropped. So is an info
/// line of the logger kClientLogger beyond kMaxInfoLinesPerSecond, because clients cause those lines. The
/// next line that is written is preceded by one with the number of dropped lines. Callable from any thread.
class NonBlockingSink final : public spdlog::sinks::base_sink<std::mutex> {
 public:
  static constexpr std::uint32_t kMaxInfoLinesPerSecond = 200;
  static constexpr std::string_view kClientLogger = "clients";

  /// `descriptor` stays open as long as the sink lives.
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
