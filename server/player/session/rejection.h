// The reason for rejecting a message.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include <tl/expected.hpp>

#include <talus/protocol/message.h>

#include "config/access/auth_failure.h"

namespace talus::server {

struct Rejection {
  wire::ErrorCode code{};
  std::string text;                           // for the client
  std::string why{};                          // additional text for the log only
  std::optional<AuthFailure> auth_failure{};  // if the token is the reason
  bool repeated = false;                      // the log need not repeat it
};

[[nodiscard]] inline tl::unexpected<Rejection> rejected(wire::ErrorCode code, std::string text) {
  return tl::make_unexpected(Rejection{code, std::move(text)});
}

}  // namespace talus::server
