// Results of a run as numbers with stable names: for --fail-if, --compare and the JSON.
#pragma once

#include <string>
#include <vector>

#include "run_result.h"
#include "thresholds.h"

namespace talus::load {

[[nodiscard]] Figures figures_of(const RunResult& result);

[[nodiscard]] bool is_figure(const std::string& name);
/// All names, for --help.
[[nodiscard]] std::string figure_names();

}  // namespace talus::load
