#include "conditions.h"

#include <sstream>

#include <fmt/format.h>

#include "figures.h"

namespace talus::load {
namespace {

bool holds(const Condition& condition, double value) {
  const std::string& relation = condition.relation;
  if (relation == ">") return value > condition.bound;
  if (relation == ">=") return value >= condition.bound;
  if (relation == "<") return value < condition.bound;
  if (relation == "<=") return value <= condition.bound;
  if (relation == "==") return value == condition.bound;
  return value != condition.bound;
}

}  // namespace

tl::expected<Condition, std::string> parse_condition(const std::string& text) {
  const auto wrong = [&](const std::string& why) {
    return tl::unexpected{"--fail-if " + text + ": " + why +
                          "; write a figure, a relation and a number, as in p99_ms>50"};
  };
  const auto at = text.find_first_of("<>=!");
  if (at == std::string::npos) return wrong("there is no relation in it");
  const auto end = text.find_first_not_of("<>=!", at);
  Condition condition{text, text.substr(0, at), text.substr(at, end - at), 0};
  const std::string& relation = condition.relation;
  if (relation != ">" && relation != ">=" && relation != "<" && relation != "<=" && relation != "==" &&
      relation != "!=") {
    return wrong("'" + relation + "' is none of > >= < <= == !=");
  }
  std::istringstream number{end == std::string::npos ? "" : text.substr(end)};
  if (!(number >> condition.bound) || !number.eof()) return wrong("no number follows the relation");
  if (!is_figure(condition.figure)) {
    return wrong("there is no figure '" + condition.figure + "'; --help lists them");
  }
  return condition;
}

std::vector<std::string> those_that_hold(const std::vector<Condition>& conditions, const Figures& figures) {
  std::vector<std::string> lines;
  for (const Condition& condition : conditions) {
    const auto found = figures.find(condition.figure);
    if (found == figures.end()) {
      lines.push_back(
          fmt::format("--fail-if {}: {} was not measured in this run", condition.text, condition.figure));
    } else if (holds(condition, found->second)) {
      lines.push_back(
          fmt::format("--fail-if {}: {} is {:.6g}", condition.text, condition.figure, found->second));
    }
  }
  return lines;
}

}  // namespace talus::load
