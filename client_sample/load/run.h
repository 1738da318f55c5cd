// One run, from the first connection to the last.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "plan.h"
#include "run_result.h"

namespace talus::load {

/// Blocks until the run is over; SIGINT ends it early and keeps the results so far. REQUIRES: `plan` was
/// probed.
[[nodiscard]] tl::expected<RunResult, std::string> run(const Plan& plan);

}  // namespace talus::load
