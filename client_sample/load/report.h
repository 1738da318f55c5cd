// A run's outcome for people, and for programs.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "outcome.h"

namespace talus::load {

[[nodiscard]] std::string report(const Plan& plan, const Outcome& outcome);

/// Its keys are told in tests/load/README.md and do not change; `format` would.
[[nodiscard]] nlohmann::json report_json(const Plan& plan, const Outcome& outcome);

}  // namespace talus::load
