// A progress bar with rate and time left.
#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>

namespace talus {

/// Draws on stderr where that is a terminal and the work takes over a second, ten times a second at most; the
/// destructor erases the line. Where it is none, as in a pipe or a file, prints a line every ten seconds. For
/// one thread.
class ProgressBar {
 public:
  using Clock = std::chrono::steady_clock;

  /// Where it draws, which stays open and is not owned.
  struct Place {
    std::FILE* file;
    bool terminal;
    bool lines;  // prints them where there is no terminal
    std::function<Clock::time_point()> now;
  };
  [[nodiscard]] static Place standard_error();
  /// For work of which a log tells already.
  [[nodiscard]] static Place only_terminal();

  /// `label` stands before the bar; `unit` names what is counted, as "columns".
  ProgressBar(std::string label, std::string unit, Place place = standard_error());
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar();

  /// Erases the line, so that something else may be printed there; the next count may draw it again.
  void clear();

  /// How much there is to count.
  void expect(std::uint64_t total) { total_ = total; }
  void advance(std::uint64_t amount);

  /// For work whose end is no count: `part` of it, 0 to 1, is done, and `count` units so far. `remark` ends
  /// the line.
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

/// "[#####.....]  50 %  1.2 k columns/s  3 s left": what the bar says after `seconds`.
[[nodiscard]] std::string progress_line(double part, std::uint64_t count, double seconds,
                                        const std::string& unit);

/// "50 %, 1.2 k columns/s, 3 s left": the same without the bar.
[[nodiscard]] std::string progress_words(double part, std::uint64_t count, double seconds,
                                         const std::string& unit);

}  // namespace talus
