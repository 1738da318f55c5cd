// A progress bar, for people who wait.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace talus::cli {

/// Draws on stderr where that is a terminal and the work takes over a second, a few times a second at most,
/// and takes its line away at the end.
class Progress {
 public:
  /// `label` stands before the bar.
  explicit Progress(std::string label);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `part` of the work, 0 to 1, is done; `chunks` have come so far. `remark` ends the line.
  void show(double part, std::uint64_t chunks, const std::string& remark = {});

 private:
  using Clock = std::chrono::steady_clock;
  std::string label_;
  bool terminal_;
  bool drawn_ = false;
  Clock::time_point begun_ = Clock::now();
  Clock::time_point next_draw_;
};

/// "[#####.....]  50 %  120 chunks/s  3 s left": what the bar says after `seconds`.
[[nodiscard]] std::string progress_line(double part, std::uint64_t chunks, double seconds);

}  // namespace talus::cli
