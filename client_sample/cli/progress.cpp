#include "progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace talus::cli {
namespace {

constexpr std::chrono::seconds kSilence{1};
constexpr std::chrono::milliseconds kBetweenDraws{100};

std::string duration(double seconds) {
  const auto whole = std::llround(seconds);
  if (whole < 60) return std::to_string(whole) + " s";
  if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
  return std::to_string(whole / 3600) + " h " + std::to_string(whole / 60 % 60) + " min";
}

}  // namespace

std::string progress_line(double part, std::uint64_t chunks, double seconds) {
  constexpr int kCells = 24;
  part = std::clamp(part, 0.0, 1.0);
  const auto filled = static_cast<std::size_t>(part * kCells);
  std::ostringstream line;
  line << '[' << std::string(filled, '#') << std::string(kCells - filled, '.') << "] " << std::setw(3)
       << static_cast<int>(part * 100) << " %";
  if (seconds > 0) line << "  " << std::llround(static_cast<double>(chunks) / seconds) << " chunks/s";
  if (part > 0) line << "  " << duration(seconds * (1 - part) / part) << " left";
  return line.str();
}

Progress::Progress(std::string label)
    : label_{std::move(label)}, terminal_{::isatty(STDERR_FILENO) == 1}, next_draw_{begun_ + kSilence} {}

Progress::~Progress() {
  if (drawn_) std::cerr << "\r\x1b[K" << std::flush;
}

void Progress::show(double part, std::uint64_t chunks, const std::string& remark) {
  if (!terminal_) return;
  const auto now = Clock::now();
  if (now < next_draw_) return;
  next_draw_ = now + kBetweenDraws;
  drawn_ = true;
  const double seconds = std::chrono::duration<double>(now - begun_).count();
  std::cerr << '\r' << label_ << ' ' << progress_line(part, chunks, seconds) << (remark.empty() ? "" : "  ")
            << remark << "\x1b[K" << std::flush;
}

}  // namespace talus::cli
