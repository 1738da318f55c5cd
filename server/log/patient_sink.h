// Where log lines go: a descriptor that may be a pipe nobody reads, under a flood that a stranger causes.
#pragma once

#include <cstdint>
#include <mutex>
#include <string_view>

#include <spdlog/sinks/base_sink.h>

namespace talus::server {

/// Writes lines to `descriptor` and never waits for its reader: what does not fit at once is left out, and so
/// are info lines of the logger kOfClients past kInfoLinesASecond, as strangers cause those. How many were is
/// said when there is room again. Any thread.
class PatientSink final : public spdlog::sinks::base_sink<std::mutex> {
 public:
  static constexpr std::uint32_t kInfoLinesASecond = 200;
  static constexpr std::string_view kOfClients = "clients";

  /// The descriptor must stay open as long as the sink.
  explicit PatientSink(int descriptor) : descriptor_{descriptor} {}

 private:
  void sink_it_(const spdlog::details::log_msg& message) override;
  void flush_() override {}

  [[nodiscard]] bool within_budget(const spdlog::details::log_msg& message);
  [[nodiscard]] bool write_line(const spdlog::details::log_msg& message);

  int descriptor_;
  spdlog::log_clock::time_point second_{};
  std::uint32_t info_lines_ = 0;  // in that second
  std::uint64_t left_out_ = 0;
};

}  // namespace talus::server
