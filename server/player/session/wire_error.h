// Edit errors on the wire.
#pragma once

#include <chrono>

#include <talus/protocol/message.h>

#include "chunks/edit_error.h"

namespace talus::server {

struct WireError {
  wire::ErrorCode code{};
  std::chrono::milliseconds retry_after{};
};

[[nodiscard]] WireError wire_error(EditErrorCode code);

}  // namespace talus::server
