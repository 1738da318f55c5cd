// What SIGHUP changes: settings that the file has now, beside those that the server has.
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

/// Those that differ, in the order of fields().
[[nodiscard]] std::vector<SettingChange> changes_between(const Config& before, const Config& after);

/// `before`, with those of `after` that count without a restart.
[[nodiscard]] Config changed_while_running(const Config& before, const Config& after);

}  // namespace talus::server
