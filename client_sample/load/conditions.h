// Figures by name, and conditions on them: "p99_ms>50".
#pragma once

#include <map>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace talus::load {

/// What a run measured, flat; what it could not measure is missing.
using Figures = std::map<std::string, double>;

struct Condition {
  std::string text;  // as it was given
  std::string figure;
  std::string relation;  // > >= < <= == !=
  double bound = 0;
};

[[nodiscard]] tl::expected<Condition, std::string> parse_condition(const std::string& text);

/// One line a condition that holds, with the figure's value; and one a condition whose figure is missing.
[[nodiscard]] std::vector<std::string> those_that_hold(const std::vector<Condition>& conditions,
                                                       const Figures& figures);

}  // namespace talus::load
