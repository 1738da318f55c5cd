// Figures by name, and thresholds on them: "p99_ms>50".
#pragma once

#include <map>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace talus::load {

/// What a run measured, flat; what it could not measure is missing.
using Figures = std::map<std::string, double>;

struct Threshold {
  std::string text;  // as it was given
  std::string figure;
  std::string relation;  // > >= < <= == !=
  double bound = 0;
};

[[nodiscard]] tl::expected<Threshold, std::string> parse_threshold(const std::string& text);

/// One line a threshold that holds, with the figure's value; and one a threshold whose figure is missing.
[[nodiscard]] std::vector<std::string> crossed_thresholds(const std::vector<Threshold>& thresholds,
                                                          const Figures& figures);

}  // namespace talus::load
