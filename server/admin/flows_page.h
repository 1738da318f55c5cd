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

/// Three tables in printable ASCII, for a terminal of 80 columns where names are short. A flow's name is as
/// access.blocked_file has it, unless it is longer than 48 bytes and ends in "...".
[[nodiscard]] std::string flows_text(const FlowsReport& report);

/// One object, in ASCII. Rates are per second; the units are seconds, bytes and refusals. Names are whole up
/// to FlowName::kMaxBytes; "cut" marks longer ones.
[[nodiscard]] std::string flows_json(const FlowsReport& report);

}  // namespace talus::server
