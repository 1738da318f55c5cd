// Changes made by SIGHUP: differences between the file's settings and the server's.
#pragma once

#include <string>
#include <vector>

#include "config/config.h"
#include "config/fields.h"

namespace talus::server {

struct SettingChange {
  std::string line;  // "limits.connections: 128 -> 256, for new sessions"
  Counts counts{};
};

/// Returns the settings that differ, in the order of fields().
[[nodiscard]] std::vector<SettingChange> changes_between(const Config& before, const Config& after);

/// Returns `before` with the settings of `after` that take effect without a restart.
[[nodiscard]] Config changed_while_running(const Config& before, const Config& after);

}  // namespace talus::server
