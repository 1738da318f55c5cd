// Why a message is not accepted.
#pragma once

#include <optional>
#include <string>

#include <talus/protocol/message.h>

#include "access/auth_failure.h"

namespace talus::server {

struct Rejection {
  wire::ErrorCode code{};
  std::string text;                // for the client
  std::string why{};               // more, for the log alone
  std::optional<AuthFailure> auth_failure{};  // where the token is the reason
};

}  // namespace talus::server
