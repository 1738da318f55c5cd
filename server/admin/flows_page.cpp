#include "admin/flows_page.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "runtime/log/escape.h"

namespace talus::server {
namespace {

constexpr std::size_t kNameBytesShown = 48;  // longest name shown

/// Display format of a measure.
struct MeasureFormat {
  std::string_view title;
  std::string_view rate;   // unit of rates
  std::string_view total;  // unit of totals
  double per_rate;         // measure per second in one such unit
  double per_total;
  std::string_view key;  // name in JSON
  double per_key_unit;
};

constexpr double kMebibyteBytes = 1 << 20;
constexpr std::array<MeasureFormat, kFlowMeasures> kFormats{
    MeasureFormat{"GENERATOR TIME", "ms/s", "total s", 1e6, 1e9, "generator_seconds", 1e9},
    MeasureFormat{"SENT", "MiB/s", "total MiB", kMebibyteBytes, kMebibyteBytes, "sent_bytes", 1},
    MeasureFormat{"REFUSALS", "/min", "total", 1.0 / 60, 1, "refusals", 1}};

std::string name_shown(const FlowName& name) {
  const std::string text = escaped(name.text, kNameBytesShown);
  return name.kind == FlowName::Kind::subject ? "subject " + text : text;
}

/// Writes the members of a JSON object.
std::string json_of(const FlowFigures& figures, const MeasureFormat& shown) {
  return fmt::format(R"("per_second_10_s": {}, "per_second_1_min": {}, "total": {})",
                     figures.in_ten_seconds / shown.per_key_unit, figures.in_a_minute / shown.per_key_unit,
                     static_cast<double>(figures.total) / shown.per_key_unit);
}

std::string json_of(const FlowName& name) {
  // A truncated name may end inside a UTF-8 character.
  const std::string text =
      nlohmann::json(name.text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  return fmt::format(R"("{}": {}{})", name.kind == FlowName::Kind::subject ? "subject" : "address", text,
                     name.cut ? R"(, "cut": true)" : "");
}

}  // namespace

std::string flows_text(const FlowsReport& report) {
  std::size_t width = 20;
  for (const TopFlows& flows : report.top) {
    for (const FlowFigures& each : flows.top) width = std::max(width, name_shown(*each.name).size());
  }
  std::string page = fmt::format("{} session{}, {} flow{}\n", report.sessions,
                                 report.sessions == 1 ? "" : "s", report.flows, report.flows == 1 ? "" : "s");
  const auto out = std::back_inserter(page);
  for (std::size_t i = 0; i < kFlowMeasures; ++i) {
    const MeasureFormat& shown = kFormats[i];
    const TopFlows& flows = report.top[i];
    const auto row = [&](std::string_view name, const FlowFigures& figures) {
      const double share = flows.all.in_a_minute > 0 ? figures.in_a_minute / flows.all.in_a_minute : 0;
      fmt::format_to(out, "{:<{}} {:>12.1f} {:>13.1f} {:>5.0f} % {:>12.{}f}\n", name, width,
                     figures.in_ten_seconds / shown.per_rate, figures.in_a_minute / shown.per_rate,
                     100 * share, static_cast<double>(figures.total) / shown.per_total,
                     shown.per_total > 1 ? 1 : 0);
    };
    fmt::format_to(out, "\n{:<{}} {:>12} {:>13} {:>7} {:>12}\n", shown.title, width,
                   fmt::format("{}, 10 s", shown.rate), fmt::format("{}, 1 min", shown.rate), "share",
                   shown.total);
    for (const FlowFigures& each : flows.top) {
      // Skips flows whose rates would be shown as zeros.
      const double rate = std::max(each.in_ten_seconds, each.in_a_minute) / shown.per_rate;
      if (rate >= 0.05 || each.in_a_minute > 0.005 * flows.all.in_a_minute) row(name_shown(*each.name), each);
    }
    row("all flows", flows.all);
  }
  return page;
}

std::string flows_json(const FlowsReport& report) {
  std::string page = fmt::format("{{\n  \"sessions\": {},\n  \"flows\": {}", report.sessions, report.flows);
  const auto out = std::back_inserter(page);
  for (std::size_t i = 0; i < kFlowMeasures; ++i) {
    const MeasureFormat& shown = kFormats[i];
    fmt::format_to(out, ",\n  \"{}\": {{\n    \"all\": {{{}}},\n    \"top\": [", shown.key,
                   json_of(report.top[i].all, shown));
    std::string_view comma;
    for (const FlowFigures& each : report.top[i].top) {
      fmt::format_to(out, "{}\n      {{{}, {}}}", comma, json_of(*each.name), json_of(each, shown));
      comma = ",";
    }
    page += "]\n  }";
  }
  return page + "\n}\n";
}

}  // namespace talus::server
