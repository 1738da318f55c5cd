// Checks that the settings of [cluster] fit each other. Pure.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "config/config.h"

namespace talus::server {

/// Does not read files. An error is one line that begins with a key.
[[nodiscard]] tl::expected<void, std::string> check_cluster(const Cluster& cluster);

/// Also checks other settings that a cluster's server needs.
[[nodiscard]] tl::expected<void, std::string> check_member(const Config& config);

}  // namespace talus::server
