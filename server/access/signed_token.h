// Tokens that say themselves who comes, with which rights and until when: JSON Web Tokens (RFC 7519), signed
// by HMAC-SHA-256 (HS256) and by nothing else. The parsing and the signature are libjwt's. Pure.
//
// Claims: "exp" (required) and "nbf", whole seconds since 1970; "sub"; "rights", as Rights::parse reads them,
// "read" where it is missing. Others are left alone; a header with "crit" is refused.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "access/key_file.h"
#include "access/rights.h"

namespace talus::server {

/// By how much the clock of who made a token may differ: it is taken that much before "nbf" and after "exp".
inline constexpr std::chrono::seconds kClockSkew{30};

/// Of HS256's keys: RFC 7518 asks for the length of its hash at least.
inline constexpr KeyBounds kSigningKeyBounds{32, 4096};

struct Claims {
  std::string subject;  // as it came: escape before logging
  Rights rights{Right::read};
  std::chrono::sys_seconds expires;
};

struct TokenFault {
  bool ours = false;     // signed by the key
  bool expired = false;  // ours, and its time is over
  std::string why;       // for the operator's log, not for the client
};

/// What the token says, where it is signed by the key and its time is now.
[[nodiscard]] tl::expected<Claims, TokenFault> read_signed_token(const Secret& key, std::string_view token,
                                                                 std::chrono::sys_seconds now);

/// A token that is valid from now on. An error is one line.
[[nodiscard]] tl::expected<std::string, std::string> make_signed_token(const Secret& key,
                                                                       const Claims& claims,
                                                                       std::chrono::sys_seconds now);

}  // namespace talus::server
