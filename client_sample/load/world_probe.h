// Collects facts about a world before players join.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "plan.h"

namespace talus::load {

/// Connects once, and completes `plan`: the server's address, its world, the groups' starts and the fixed
/// set. An error is one line.
[[nodiscard]] tl::expected<void, std::string> probe_world(Plan& plan);

}  // namespace talus::load
