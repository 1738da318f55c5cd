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

/// The error's message, unless it may have the server's paths and addresses, which only its log has.
[[nodiscard]] std::string_view client_text(const EditError& error);

}  // namespace talus::server
