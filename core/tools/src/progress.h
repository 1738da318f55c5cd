// A progress bar with rate and time left, for people who wait.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace talus::tools {

/// Draws on stderr where that is a terminal and the work takes over a second, and takes its line away at
/// the end. Not thread-safe: one thread counts.
class Progress {
 public:
  /// `unit` names what is counted, such as "columns".
  Progress(std::string label, std::string unit);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// Says how much there will be to count.
  void expect(std::uint64_t total) { total_ = total; }
  void advance(std::uint64_t amount);

 private:
  using Clock = std::chrono::steady_clock;
  void draw(Clock::time_point now);

  std::string label_;
  std::string unit_;
  bool terminal_;
  std::uint64_t total_ = 0;
  std::uint64_t done_ = 0;
  Clock::time_point started_ = Clock::now();
  Clock::time_point next_draw_;
  bool drawn_ = false;
};

/// "[#####.....]  50 %  1.2 M columns/s  3 s left": what the bar says. `seconds` is the time so far.
[[nodiscard]] std::string progress_line(std::uint64_t done, std::uint64_t total, double seconds,
                                        const std::string& unit);

}  // namespace talus::tools
