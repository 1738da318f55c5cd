// Edit errors on the wire.
#pragma once

#include <chrono>
#include <string_view>

#include <talus/protocol/message.h>

#include "chunks/edit_error.h"

namespace talus::server {

struct WireError {
  wire::ErrorCode code{};
  std::chrono::milliseconds retry_after{};
};

[[nodiscard]] WireError wire_error(EditErrorCode code);

/// Returns the error's message, or a general one if it may contain paths and addresses of the server, which
/// only the log has.
[[nodiscard]] std::string_view client_text(const EditError& error);

}  // namespace talus::server
