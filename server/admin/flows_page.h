// The flows that use most, as a text table and as JSON.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "limits/flows/flow_uses.h"

namespace talus::server {

struct FlowsReport {
  std::uint64_t sessions = 0;  // open connections
  std::uint64_t flows = 0;     // active flows
  std::array<TopFlows, kFlowMeasures> top;
};

/// Formats three tables in printable ASCII; with short names they fit into 80 columns. A flow's name can be
/// used in access.blocked_file, unless it was longer than 48 bytes and ends in "...".
[[nodiscard]] std::string flows_text(const FlowsReport& report);

/// Formats one JSON object in ASCII. Rates are per second; the units are seconds, bytes and refusals. Names
/// longer than FlowName::kMaxBytes are truncated and marked by "cut".
[[nodiscard]] std::string flows_json(const FlowsReport& report);

}  // namespace talus::server
