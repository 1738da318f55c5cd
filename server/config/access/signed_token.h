// Signed tokens: JSON Web Tokens (RFC 7519) in compact form, signed with HMAC-SHA-256 (HS256), the only
// accepted algorithm. The functions are pure: the caller passes the time.
//
// Claims: "exp" (required), "nbf" and "iat", seconds since 1970; "sub"; "jti"; "rights", parsed by
// Rights::parse, default "read"; "edit_in" and "edit_not_in", parsed by Boxes::parse: the boxes to which
// edits are restricted (default everywhere) and from which they are excluded. Other claims are ignored. A
// header with "crit", or with a "typ" other than "JWT", is rejected.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "config/access/key_file.h"
#include "config/access/rights.h"
#include "config/boxes.h"

namespace talus::server {

/// Allowed difference between this server's clock and the token issuer's: a token is accepted this long
/// before "nbf" and after "exp".
inline constexpr std::chrono::seconds kClockSkew{30};

/// Length of a signing key. RFC 7518 section 3.2 requires at least the length of the hash.
inline constexpr KeyBounds kSigningKeyBounds{32, 4096};

struct Claims {
  std::string subject;  // unescaped: escape it before logging
  Rights rights{Right::read};
  std::chrono::sys_seconds expires;
  std::string id{};  // "jti", unescaped; may be empty
  std::optional<std::chrono::sys_seconds> issued{};
  std::optional<Boxes> edit_in{};  // nullopt: everywhere; empty: nowhere
  Boxes edit_not_in{};
};

struct TokenError {
  bool signed_by_key = false;  // the signature is right; something else is wrong
  bool expired = false;        // only the time is wrong
  std::string reason;          // for the operator's log; for the client only if signed_by_key
};

/// Returns the claims of a token that `key` signed and that is valid at `now`. Checks the signature in
/// constant time before parsing any JSON.
[[nodiscard]] tl::expected<Claims, TokenError> read_signed_token(const Secret& key, std::string_view token,
                                                                 std::chrono::sys_seconds now);

/// Makes a token with these claims and an "iat" of `now`, ignoring `claims.issued`. An error is one line: the
/// subject is not UTF-8, or the token exceeds the protocol's string limit.
[[nodiscard]] tl::expected<std::string, std::string> make_signed_token(const Secret& key,
                                                                       const Claims& claims,
                                                                       std::chrono::sys_seconds now);

}  // namespace talus::server
