// Figures by name, and thresholds on them: "p99_ms>50".
#pragma once

#include <map>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace talus::load {

/// Measurements of a run; values that could not be measured are missing.
using Figures = std::map<std::string, double>;

struct Threshold {
  std::string text;  // as given
  std::string figure;
  std::string relation;  // > >= < <= == !=
  double bound = 0;
};

[[nodiscard]] tl::expected<Threshold, std::string> parse_threshold(const std::string& text);

/// One line for each threshold that holds, with the figure's value, and for each one whose figure is missing.
[[nodiscard]] std::vector<std::string> crossed_thresholds(const std::vector<Threshold>& thresholds,
                                                          const Figures& figures);

}  // namespace talus::load
