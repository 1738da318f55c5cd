// One run, from the first connection to the last.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "outcome.h"
#include "plan.h"

namespace talus::load {

/// Blocks until it is over; SIGINT ends it early, with what was measured until then. `plan` has been scouted.
[[nodiscard]] tl::expected<Outcome, std::string> run(const Plan& plan);

}  // namespace talus::load
