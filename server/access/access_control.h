// Who may join, and with which rights.
#pragma once

#include <array>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "access/auth_failure.h"
#include "access/key_file.h"
#include "access/revoked_tokens.h"
#include "access/rights.h"
#include "config/config.h"

namespace talus::server {

/// SHA-256 of the shared secret. The secret itself is not kept.
using SecretDigest = std::array<unsigned char, 32>;

/// The contents of the configured key files.
struct Keys {
  std::optional<SecretDigest> shared_secret;
  std::vector<Secret> signing_keys;  // the current key first
  RevokedTokens revoked;
  std::vector<std::string> warnings;  // one line each, about the files

  [[nodiscard]] bool any() const { return shared_secret || !signing_keys.empty(); }
};

/// An error is one line that begins with the setting's key: the file is bad, or the settings let nobody in.
[[nodiscard]] tl::expected<Keys, std::string> load_keys(const Access& settings);

/// What a token, or the lack of one, gives a session.
struct Grant {
  Rights rights{Right::read};
  std::string subject;  // of a signed token, as the token has it: escape before logging
  std::optional<std::chrono::sys_seconds> expires;  // the session ends between then and kClockSkew later
  std::string token_id{};                           // its "jti", as the token has it; empty: none
  std::optional<std::chrono::sys_seconds> issued{};
};

struct AuthError {
  AuthFailure failure{};
  std::string reason;  // for the operator's log; empty where describe() says it all
};

/// Callable from any thread.
class AccessControl {
 public:
  /// `keys` are those that load_keys(settings) returned.
  AccessControl(const Access& settings, Keys keys);

  /// Checks the token of a Hello; empty: the client has none. A token is accepted where it is the shared
  /// secret or signed by one of the keys. Without configured keys a token is ignored.
  [[nodiscard]] tl::expected<Grant, AuthError> admit(std::string_view token,
                                                     std::chrono::sys_seconds now) const;

  /// Whether the token of a session that was admitted has been revoked since.
  [[nodiscard]] bool is_revoked(const Grant& grant) const;

  /// Reads the key files and the list of revoked tokens again. If one file is bad, all of it stays as it was,
  /// and the error is one line that says why. Else the value is one line for the log, warnings about the
  /// files included.
  [[nodiscard]] tl::expected<std::string, std::string> reload();

 private:
  [[nodiscard]] std::shared_ptr<const Keys> keys() const;

  const Access settings_;
  const Rights secret_rights_;
  mutable std::mutex mutex_;
  std::shared_ptr<const Keys> keys_;
};

}  // namespace talus::server
