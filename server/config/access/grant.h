// The rights of one session.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "config/access/rights.h"
#include "config/boxes.h"

namespace talus::server {

/// Rights and restrictions that a token, or the lack of one, gives a session.
struct Grant {
  Rights rights{Right::read};
  std::string subject;                              // of a signed token, unescaped: escape it before logging
  std::optional<std::chrono::sys_seconds> expires;  // the session ends between then and kClockSkew later
  std::string token_id{};                           // "jti", unescaped; may be empty
  std::optional<std::chrono::sys_seconds> issued{};
  std::optional<Boxes> edit_in{};  // nullopt: everywhere
  Boxes edit_not_in{};             // never here
};

}  // namespace talus::server
