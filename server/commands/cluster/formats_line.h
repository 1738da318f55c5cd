// What a stream says of the formats of its messages, for people.
#pragma once

#include <string>

#include "cluster/jetstream/stream_info.h"

namespace talus::server::cluster_tool {

/// In one line, without a break; and what this talusd reads, where there may be more. Where the description
/// is not understood, it stands there as it is.
[[nodiscard]] std::string formats_line(const jetstream::StreamInfo& info);

}  // namespace talus::server::cluster_tool
