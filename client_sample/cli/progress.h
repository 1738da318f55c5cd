// A progress bar on a terminal; nothing anywhere else.
#pragma once

#include <chrono>
#include <string>

namespace talus::cli {

class Progress {
 public:
  /// `what` stands before the bar.
  explicit Progress(std::string what);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done` of `total`, and a remark at the end of the line. Draws a few times a second at most.
  void show(double done, double total, const std::string& remark);

 private:
  using Clock = std::chrono::steady_clock;
  std::string what_;
  bool terminal_;
  bool drawn_ = false;
  Clock::time_point begun_ = Clock::now();
  Clock::time_point last_{};
};

}  // namespace talus::cli
