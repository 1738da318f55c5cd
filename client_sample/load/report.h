// Results of a run for humans and for programs.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "run_result.h"

namespace talus::load {

[[nodiscard]] std::string report(const Plan& plan, const RunResult& result);

/// Keys are documented in tests/load/README.md and are stable, unless `format` changes.
[[nodiscard]] nlohmann::json report_json(const Plan& plan, const RunResult& result);

}  // namespace talus::load
