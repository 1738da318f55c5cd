#include <talus/progress/progress_bar.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "terminal.h"

namespace talus {
namespace {

constexpr std::chrono::seconds kFirstDraw{1};
constexpr std::chrono::milliseconds kBetweenDraws{100};
constexpr std::chrono::seconds kBetweenLines{10};

std::string duration(double seconds) {
  const auto whole = std::llround(seconds);
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

std::string progress_words(double part, std::uint64_t count, double seconds, const std::string& unit) {
  part = std::clamp(part, 0.0, 1.0);
  std::string words = std::to_string(static_cast<int>(part * 100)) + " %";
  if (seconds > 0) words += ", " + rate(static_cast<double>(count) / seconds) + unit + "/s";
  if (part > 0) words += ", " + duration(seconds * (1 - part) / part) + " left";
  return words;
}

std::string progress_line(double part, std::uint64_t count, double seconds, const std::string& unit) {
  constexpr std::size_t kCells = 24;
  part = std::clamp(part, 0.0, 1.0);
  const auto filled = static_cast<std::size_t>(part * kCells);
  std::array<char, 16> percent{};
  std::snprintf(percent.data(), percent.size(), "%3d %%", static_cast<int>(part * 100));
  std::string line =
      "[" + std::string(filled, '#') + std::string(kCells - filled, '.') + "] " + percent.data();
  if (seconds > 0) line += "  " + rate(static_cast<double>(count) / seconds) + unit + "/s";
  if (part > 0) line += "  " + duration(seconds * (1 - part) / part) + " left";
  return line;
}

ProgressBar::Place ProgressBar::standard_error() {
  return {stderr, standard_error_is_terminal(), true, &Clock::now};
}

ProgressBar::Place ProgressBar::only_terminal() {
  Place place = standard_error();
  place.lines = false;
  return place;
}

ProgressBar::ProgressBar(std::string label, std::string unit, Place place)
    : label_{std::move(label)}, unit_{std::move(unit)}, place_{std::move(place)}, started_{place_.now()} {
  next_draw_ = started_ + (place_.terminal ? kFirstDraw : kBetweenLines);
}

ProgressBar::~ProgressBar() {
  clear();
}

void ProgressBar::clear() {
  if (!std::exchange(drawn_, false)) return;
  std::fputs("\r\x1b[K", place_.file);
  std::fflush(place_.file);
}

void ProgressBar::advance(std::uint64_t amount) {
  done_ = std::min(total_, done_ + amount);
  show(total_ == 0 ? 1 : static_cast<double>(done_) / static_cast<double>(total_), done_);
}

void ProgressBar::show(double part, std::uint64_t count, const std::string& remark) {
  if (!place_.terminal && !place_.lines) return;
  const auto now = place_.now();
  if (now < next_draw_) return;
  const double seconds = std::chrono::duration<double>(now - started_).count();
  const std::string end = remark.empty() ? "" : (place_.terminal ? "  " : ", ") + remark;
  if (!place_.terminal) {
    next_draw_ = now + kBetweenLines;
    const std::string line = label_ + ": " + progress_words(part, count, seconds, unit_) + end + "\n";
    std::fputs(line.c_str(), place_.file);
    std::fflush(place_.file);
    return;
  }
  next_draw_ = now + kBetweenDraws;
  drawn_ = true;
  const std::string line = "\r" + label_ + " " + progress_line(part, count, seconds, unit_) + end + "\x1b[K";
  std::fputs(line.c_str(), place_.file);
  std::fflush(place_.file);
}

}  // namespace talus
