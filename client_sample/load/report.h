// What a run found, for people and for programs.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "run_result.h"

namespace talus::load {

[[nodiscard]] std::string report(const Plan& plan, const RunResult& result);

/// Its keys are told in tests/load/README.md and do not change; `format` would.
[[nodiscard]] nlohmann::json report_json(const Plan& plan, const RunResult& result);

}  // namespace talus::load
