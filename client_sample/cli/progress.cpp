#include "progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace talus::cli {

Progress::Progress(std::string what) : what_{std::move(what)}, terminal_{::isatty(STDERR_FILENO) == 1} {}

Progress::~Progress() {
  if (drawn_) std::cerr << "\r\x1b[K" << std::flush;
}

void Progress::show(double done, double total, const std::string& remark) {
  constexpr std::chrono::milliseconds kBetween{100};
  constexpr int kCells = 24;
  const auto now = Clock::now();
  if (!terminal_ || now - last_ < kBetween || total <= 0) return;
  last_ = now;
  drawn_ = true;
  const double part = std::clamp(done / total, 0.0, 1.0);
  const auto filled = static_cast<int>(part * kCells);
  std::string bar;
  for (int cell = 0; cell < kCells; ++cell) bar += cell < filled ? "█" : "░";
  const double elapsed = std::chrono::duration<double>(now - begun_).count();
  const std::string left =
      part > 0.02 ? ", " + std::to_string(std::lround(elapsed / part - elapsed)) + " s left" : "";
  std::cerr << '\r' << what_ << ' ' << bar << ' ' << std::lround(part * 100) << " %" << left << "  " << remark
            << "\x1b[K" << std::flush;
}

}  // namespace talus::cli
