// A progress bar with rate and remaining time.
#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>

namespace talus {

/// On a terminal, draws on stderr if the work takes over a second, at most ten times a second; the destructor
/// erases the line. Otherwise, such as in a pipe or a file, prints a line every ten seconds. Not thread-safe.
class ProgressBar {
 public:
  using Clock = std::chrono::steady_clock;

  /// Output, which must stay open and is not owned.
  struct Place {
    std::FILE* file;
    bool terminal;
    bool lines;  // print lines if it is not a terminal
    std::function<Clock::time_point()> now;
  };
  [[nodiscard]] static Place standard_error();
  /// For work whose progress is logged elsewhere.
  [[nodiscard]] static Place only_terminal();

  /// `label` precedes the bar; `unit` names what is counted, such as "columns".
  ProgressBar(std::string label, std::string unit, Place place = standard_error());
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar();

  /// Erases the line, so that other output can be printed; the next count may draw it again.
  void clear();

  /// Sets the total count.
  void expect(std::uint64_t total) { total_ = total; }
  void advance(std::uint64_t amount);

  /// For work whose total is not a count: `part` of it, 0 to 1, and `count` units are done. `remark` is
  /// appended to the line.
  void show(double part, std::uint64_t count, const std::string& remark = {});

 private:
  std::string label_;
  std::string unit_;
  Place place_;
  bool drawn_ = false;
  std::uint64_t total_ = 0;
  std::uint64_t done_ = 0;
  Clock::time_point started_;
  Clock::time_point next_draw_;
};

/// "[#####.....]  50 %  1.2 k columns/s  3 s left": the bar after `seconds`.
[[nodiscard]] std::string progress_line(double part, std::uint64_t count, double seconds,
                                        const std::string& unit);

/// "50 %, 1.2 k columns/s, 3 s left": without the bar.
[[nodiscard]] std::string progress_words(double part, std::uint64_t count, double seconds,
                                         const std::string& unit);

}  // namespace talus
