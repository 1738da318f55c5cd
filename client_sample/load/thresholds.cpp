#include "thresholds.h"

#include <sstream>

#include <fmt/format.h>

#include "figures.h"

namespace talus::load {
namespace {

bool holds(const Threshold& threshold, double value) {
  const std::string& relation = threshold.relation;
  if (relation == ">") return value > threshold.bound;
  if (relation == ">=") return value >= threshold.bound;
  if (relation == "<") return value < threshold.bound;
  if (relation == "<=") return value <= threshold.bound;
  if (relation == "==") return value == threshold.bound;
  return value != threshold.bound;
}

}  // namespace

tl::expected<Threshold, std::string> parse_threshold(const std::string& text) {
  const auto wrong = [&](const std::string& why) {
    return tl::unexpected{"--fail-if " + text + ": " + why +
                          "; write a figure, a relation and a number, as in p99_ms>50"};
  };
  const auto at = text.find_first_of("<>=!");
  if (at == std::string::npos) return wrong("it has no relation");
  const auto end = text.find_first_not_of("<>=!", at);
  Threshold threshold{text, text.substr(0, at), text.substr(at, end - at), 0};
  const std::string& relation = threshold.relation;
  if (relation != ">" && relation != ">=" && relation != "<" && relation != "<=" && relation != "==" &&
      relation != "!=") {
    return wrong("'" + relation + "' is not one of > >= < <= == !=");
  }
  std::istringstream number{end == std::string::npos ? "" : text.substr(end)};
  if (!(number >> threshold.bound) || !number.eof()) return wrong("no number follows the relation");
  if (!is_figure(threshold.figure)) {
    return wrong("unknown figure '" + threshold.figure + "'; --help lists them");
  }
  return threshold;
}

std::vector<std::string> crossed_thresholds(const std::vector<Threshold>& thresholds,
                                            const Figures& figures) {
  std::vector<std::string> lines;
  for (const Threshold& threshold : thresholds) {
    const auto found = figures.find(threshold.figure);
    if (found == figures.end()) {
      lines.push_back(
          fmt::format("--fail-if {}: {} was not measured in this run", threshold.text, threshold.figure));
    } else if (holds(threshold, found->second)) {
      lines.push_back(
          fmt::format("--fail-if {}: {} is {:.6g}", threshold.text, threshold.figure, found->second));
    }
  }
  return lines;
}

}  // namespace talus::load
