// What must be known of a world before players are put into it.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "plan.h"

namespace talus::load {

/// Connects once, and fills in what `plan.options` leaves open: the server's address, its world, where the
/// groups begin and the fixed set. Else one line that says why not.
[[nodiscard]] tl::expected<void, std::string> probe_world(Plan& plan);

}  // namespace talus::load
