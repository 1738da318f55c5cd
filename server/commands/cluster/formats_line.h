// Describes the message formats of a stream.
#pragma once

#include <string>

#include "cluster/jetstream/stream_info.h"

namespace talus::server::cluster_tool {

/// One line without its newline; includes what this talusd reads if the stream may have more. A description
/// that cannot be parsed is quoted as it is.
[[nodiscard]] std::string formats_line(const jetstream::StreamInfo& info);

}  // namespace talus::server::cluster_tool
