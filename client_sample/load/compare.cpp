#include "compare.h"

#include <string_view>

#include <fmt/format.h>

namespace talus::load {
namespace {

/// Keeps the table short: percentiles in between are only in the JSON.
bool is_shown(std::string_view figure) {
  const auto ends_with = [&](std::string_view end) { return figure.ends_with(end); };
  return !ends_with("p95_ms") && !ends_with("p99_9_ms") && !figure.starts_with("harness_");
}

std::string ratio_of(double before, double now) {
  if (before == 0) return now == 0 ? "" : "new";
  return fmt::format("x {:.2f}", now / before);
}

}  // namespace

tl::expected<std::string, std::string> compare(const std::string& old_text, const nlohmann::json& now) {
  const auto before = nlohmann::json::parse(old_text, nullptr, false);
  const auto has = [&](const char* key) { return before.contains(key) && before[key].is_object(); };
  if (!before.is_object() || before.value("format", 0) != now.at("format").get<int>() || !has("figures") ||
      !has("settings")) {
    return tl::unexpected{std::string{"is not what --json of this talus-load writes"}};
  }
  std::string text;
  for (const auto& [name, value] : now.at("settings").items()) {
    const auto old = before["settings"].find(name);
    if (old == before["settings"].end() || *old == value) continue;
    text += fmt::format("  setting {}: {} before, {} now\n", name, old->dump(), value.dump());
  }
  text += fmt::format("  {:<28}{:>14}{:>14}{:>10}\n", "figure", "before", "now", "ratio");
  for (const auto& [name, value] : now.at("figures").items()) {
    const auto old = before["figures"].find(name);
    if (old == before["figures"].end() || !old->is_number()) continue;
    const double was = old->get<double>();
    const double is = value.get<double>();
    if (!is_shown(name) || (was == 0 && is == 0)) continue;
    text += fmt::format("  {:<28}{:>14.6g}{:>14.6g}{:>10}\n", name, was, is, ratio_of(was, is));
  }
  return text;
}

}  // namespace talus::load
