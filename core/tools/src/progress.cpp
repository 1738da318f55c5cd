#include "progress.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

namespace talus::tools {
namespace {

constexpr std::chrono::seconds kSilence{1};
constexpr std::chrono::milliseconds kBetweenDraws{100};

std::string duration(double seconds) {
  const auto whole = static_cast<long>(seconds + 0.5);
  if (whole < 60) return std::to_string(whole) + " s";
  if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
  return std::to_string(whole / 3600) + " h " + std::to_string(whole / 60 % 60) + " min";
}

std::string rate(double per_second) {
  const auto [scaled, prefix] = per_second >= 1e6   ? std::pair{per_second / 1e6, "M "}
                                : per_second >= 1e3 ? std::pair{per_second / 1e3, "k "}
                                                    : std::pair{per_second, ""};
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f %s", scaled, prefix);
  return text.data();
}

}  // namespace

std::string progress_line(std::uint64_t done, std::uint64_t total, double seconds, const std::string& unit) {
  const double part = total == 0 ? 1 : static_cast<double>(done) / static_cast<double>(total);
  constexpr int kCells = 24;
  const auto full = static_cast<std::size_t>(part * kCells);
  const double per_second = seconds > 0 ? static_cast<double>(done) / seconds : 0;
  std::array<char, 16> percent{};
  std::snprintf(percent.data(), percent.size(), "%3d %%", static_cast<int>(part * 100));
  std::string line = "[" + std::string(full, '#') + std::string(kCells - full, '.') + "] " + percent.data() +
                     "  " + rate(per_second) + unit + "/s";
  if (per_second > 0) line += "  " + duration(static_cast<double>(total - done) / per_second) + " left";
  return line;
}

Progress::Progress(std::string label, std::string unit)
    : label_{std::move(label)},
      unit_{std::move(unit)},
      terminal_{::isatty(STDERR_FILENO) == 1},
      next_draw_{started_ + kSilence} {}

Progress::~Progress() {
  if (drawn_) std::fputs("\r\x1b[K", stderr);
}

void Progress::advance(std::uint64_t amount) {
  done_ = std::min(total_, done_ + amount);
  if (!terminal_) return;
  const auto now = Clock::now();
  if (now < next_draw_) return;
  next_draw_ = now + kBetweenDraws;
  draw(now);
}

void Progress::draw(Clock::time_point now) {
  const double seconds = std::chrono::duration<double>(now - started_).count();
  const std::string line = "\r" + label_ + " " + progress_line(done_, total_, seconds, unit_) + "\x1b[K";
  std::fputs(line.c_str(), stderr);
  drawn_ = true;
}

}  // namespace talus::tools
