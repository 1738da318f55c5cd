#include "commands/cluster/formats_line.h"

#include <fmt/format.h>

namespace talus::server::cluster_tool {

std::string formats_line(const jetstream::StreamInfo& info) {
  const cluster::EnabledFormats& enabled = info.state.enabled;
  if (!enabled.understood) return fmt::format("log format NOT understood: \"{}\"", info.description);
  if (!enabled.has_newer()) return to_string(enabled);
  return fmt::format(
      "{}; this talusd reads up to {}, and stops at the first message of a later one; upgrade it",
      to_string(enabled), cluster::kLogFormat);
}

}  // namespace talus::server::cluster_tool
