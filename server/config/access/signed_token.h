// Signed tokens: JSON Web Tokens (RFC 7519) in compact form, signed with HMAC-SHA-256 (HS256). No other
// algorithm is accepted. The functions are pure: the caller passes the time.
//
// Claims: "exp" (required), "nbf" and "iat", whole seconds since 1970; "sub"; "jti"; "rights", as
// Rights::parse reads them, "read" where it is missing; "edit_in" and "edit_not_in", boxes as Boxes::parse
// reads them: where its holder may edit, everywhere where it is missing, and where not. Other claims are
// ignored. A header with "crit", or with a "typ" other than "JWT", is refused.
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

/// Allowed difference between this server's clock and that of the token's issuer: a token is accepted this
/// long before "nbf" and after "exp".
inline constexpr std::chrono::seconds kClockSkew{30};

/// Length of a signing key. RFC 7518 section 3.2 requires at least the length of the hash.
inline constexpr KeyBounds kSigningKeyBounds{32, 4096};

struct Claims {
  std::string subject;  // as the token has it: escape before logging
  Rights rights{Right::read};
  std::chrono::sys_seconds expires;
  std::string id{};  // "jti", as the token has it; empty: none
  std::optional<std::chrono::sys_seconds> issued{};
  std::optional<Boxes> edit_in{};  // none: everywhere; empty: nowhere
  Boxes edit_not_in{};
};

struct TokenError {
  bool signed_by_key = false;  // the signature is right; something else is wrong
  bool expired = false;        // nothing but the time is wrong
  std::string reason;          // for the operator's log, not for the client
};

/// The claims of a token that `key` has signed and that is valid at `now`. The signature is checked, in a
/// time that does not depend on it, before any JSON is parsed.
[[nodiscard]] tl::expected<Claims, TokenError> read_signed_token(const Secret& key, std::string_view token,
                                                                 std::chrono::sys_seconds now);

/// A token with these claims, and "iat" of `now` whatever `claims.issued` is. An error is one line: the
/// subject is not UTF-8, or the token is longer than the protocol's strings may be.
[[nodiscard]] tl::expected<std::string, std::string> make_signed_token(const Secret& key,
                                                                       const Claims& claims,
                                                                       std::chrono::sys_seconds now);

}  // namespace talus::server
