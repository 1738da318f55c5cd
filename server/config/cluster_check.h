// Whether the settings of [cluster] fit each other. Pure.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "config/config.h"

namespace talus::server {

/// An error is one line that begins with a key. Says nothing of what files hold.
[[nodiscard]] tl::expected<void, std::string> check_cluster(const Cluster& cluster);

/// The same, and what a server of the cluster needs beside them.
[[nodiscard]] tl::expected<void, std::string> check_member(const Config& config);

}  // namespace talus::server
