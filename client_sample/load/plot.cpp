#include "plot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace talus::load {
namespace {

constexpr double kWidth = 860, kHeight = 480;
constexpr double kLeft = 76, kRight = 190, kTop = 76, kBottom = 58;
constexpr std::array kColours{"#3b6ea5", "#c8553d", "#4f8a5b", "#8a5fa8", "#b8862b", "#5b6570"};

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '&')
      out += "&amp;";
    else
      out += c;
  }
  return out;
}

std::string wait_text(double ms) {
  return ms < 999.5 ? fmt::format("{:.3g} ms", ms) : fmt::format("{:.3g} s", ms / 1000);
}

struct Axes {
  double low_ms, high_ms;  // powers of ten
  int nines;               // the highest percentile is 1 - 10^-nines

  [[nodiscard]] double x(double nines_at) const {
    return kLeft + nines_at / nines * (kWidth - kLeft - kRight);
  }
  [[nodiscard]] double y(double ms) const {
    const double part =
        (std::log10(std::max(ms, low_ms)) - std::log10(low_ms)) / (std::log10(high_ms) - std::log10(low_ms));
    return kHeight - kBottom - part * (kHeight - kTop - kBottom);
  }
};

Axes axes_for(const std::vector<Curve>& curves) {
  double low = 1e9;
  double high = 0.001;
  std::uint64_t most = 1;
  for (const Curve& curve : curves) {
    low = std::min(low, std::max(0.001, curve.waits->percentile_ms(0.01)));
    high = std::max(high, curve.waits->max_ms());
    most = std::max(most, curve.waits->count());
  }
  low = std::pow(10, std::floor(std::log10(low)));
  high = std::max(std::pow(10, std::ceil(std::log10(high))), low * 10);
  const int nines = std::clamp(static_cast<int>(std::ceil(std::log10(static_cast<double>(most)))), 2, 6);
  return {low, high, nines};
}

std::string grid(const Axes& axes) {
  std::string svg;
  for (double ms = axes.low_ms; ms <= axes.high_ms * 1.001; ms *= 10) {
    const double y = axes.y(ms);
    svg += fmt::format("<line x1='{}' x2='{}' y1='{:.1f}' y2='{:.1f}' class='grid'/>\n", kLeft,
                       kWidth - kRight, y, y);
    svg += fmt::format("<text x='{}' y='{:.1f}' class='tick' text-anchor='end'>{}</text>\n", kLeft - 10,
                       y + 4, wait_text(ms));
  }
  const auto upright = [&](double nines, const char* name) {
    const double x = axes.x(nines);
    svg += fmt::format("<line x1='{0:.1f}' x2='{0:.1f}' y1='{1}' y2='{2}' class='grid'/>\n", x, kTop,
                       kHeight - kBottom);
    svg += fmt::format("<text x='{:.1f}' y='{}' class='tick' text-anchor='middle'>{}</text>\n", x,
                       kHeight - kBottom + 20, name);
  };
  const std::array names{"0 %", "90 %", "99 %", "99.9 %", "99.99 %", "99.999 %", "99.9999 %"};
  for (int nines = 0; nines <= axes.nines; ++nines) upright(nines, names[static_cast<std::size_t>(nines)]);
  upright(std::log10(2), "50 %");
  return svg;
}

std::string line_of(const Axes& axes, const measure::Histogram& waits) {
  std::string points;
  const double last = std::min<double>(axes.nines, std::log10(static_cast<double>(waits.count())));
  constexpr int kSteps = 240;
  for (int step = 0; step <= kSteps; ++step) {
    const double nines = last * step / kSteps;
    const double ms = waits.percentile_ms(1 - std::pow(10, -nines));
    points += fmt::format("{:.1f},{:.1f} ", axes.x(nines), axes.y(ms));
  }
  return points + fmt::format("{:.1f},{:.1f}", axes.x(last), axes.y(waits.max_ms()));
}

}  // namespace

std::string plot(const std::string& title, const std::string& subtitle, const std::vector<Curve>& curves) {
  const Axes axes = axes_for(curves);
  std::string svg = fmt::format(
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {0} {1}' width='{0}' height='{1}' "
      "font-family='system-ui, DejaVu Sans, sans-serif'>\n"
      "<style>.grid{{stroke:#e4e6ea;stroke-width:1}} .tick{{font-size:12px;fill:#69707a}} "
      ".name{{font-size:13px;font-weight:600}}</style>\n"
      "<rect width='{0}' height='{1}' fill='#ffffff'/>\n"
      "<text x='{2}' y='34' font-size='18' font-weight='600' fill='#20242a'>{3}</text>\n"
      "<text x='{2}' y='55' font-size='13' fill='#69707a'>{4}</text>\n",
      kWidth, kHeight, kLeft, escaped(title), escaped(subtitle));
  svg += grid(axes);
  svg += fmt::format(
      "<text x='{:.1f}' y='{}' class='tick' text-anchor='middle'>part of all that came no later</text>\n",
      (kLeft + kWidth - kRight) / 2, kHeight - 14);

  // Names are at the ends of their lines, moved apart if they are close.
  struct Label {
    double y;
    std::size_t curve;
  };
  std::vector<Label> labels;
  for (std::size_t i = 0; i < std::min(curves.size(), kColours.size()); ++i) {
    svg += fmt::format(
        "<polyline points='{}' fill='none' stroke='{}' stroke-width='2.2' stroke-linejoin='round'/>\n",
        line_of(axes, *curves[i].waits), kColours[i]);
    labels.push_back({axes.y(curves[i].waits->max_ms()), i});
  }
  std::sort(labels.begin(), labels.end(), [](const Label& a, const Label& b) { return a.y < b.y; });
  constexpr double kLabel = 36;
  for (std::size_t i = 1; i < labels.size(); ++i)
    labels[i].y = std::max(labels[i].y, labels[i - 1].y + kLabel);
  for (const Label& label : labels) {
    const measure::Histogram& waits = *curves[label.curve].waits;
    const double x = kWidth - kRight + 14;
    svg += fmt::format("<text x='{}' y='{:.1f}' class='name' fill='{}'>{}</text>\n", x, label.y + 4,
                       kColours[label.curve], escaped(curves[label.curve].name));
    svg += fmt::format("<text x='{}' y='{:.1f}' class='tick'>p99 {}, max {}</text>\n", x, label.y + 19,
                       wait_text(waits.percentile_ms(0.99)), wait_text(waits.max_ms()));
  }
  return svg + "</svg>\n";
}

}  // namespace talus::load
