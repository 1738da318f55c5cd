// Who may join, and with which rights.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "config/access/auth_failure.h"
#include "config/access/blocked_flows.h"
#include "config/access/key_file.h"
#include "config/access/revoked_tokens.h"
#include "config/access/rights.h"
#include "config/config.h"

namespace talus::server {

/// SHA-256 of the shared secret. The secret itself is not kept.
using SecretDigest = std::array<unsigned char, 32>;

/// What tokens are checked by.
struct TokenKeys {
  std::optional<SecretDigest> shared_secret;
  std::vector<Secret> signing_keys;   // the current key first
  std::vector<std::string> warnings;  // one line each, about the files

  [[nodiscard]] bool any() const { return shared_secret || !signing_keys.empty(); }
};

/// The contents of the configured files; none of them is null.
struct Keys {
  std::shared_ptr<const TokenKeys> tokens;
  std::shared_ptr<const RevokedTokens> revoked;
  std::shared_ptr<const BlockedFlows> blocked;
  std::vector<std::string> warnings{};  // one line each, about the files

  [[nodiscard]] bool any() const { return tokens->any(); }
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
  std::optional<Boxes> edit_in{};  // where it may edit; none: everywhere
  Boxes edit_not_in{};             // where not
};

struct AuthError {
  AuthFailure failure{};
  std::string reason;     // for the operator's log; empty where describe() says it all
  bool repeated = false;  // the log knows already that this one is blocked
};

/// An address that a line of access.blocked_file blocks.
struct BlockedAddress {
  std::size_t line = 0;
  bool repeated = false;  // it is not the first whom the line blocks since the file was read
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

  /// Whether who has no token may read. Cheap: every answer by HTTP asks.
  [[nodiscard]] bool lets_anybody_read() const { return anybody_reads_.load(std::memory_order_relaxed); }
  /// Whether anybody can have a token that is accepted.
  [[nodiscard]] bool has_keys() const { return keys()->any(); }

  /// Why a session that was admitted may not stay: its token was revoked since, or its subject blocked.
  [[nodiscard]] std::optional<AuthFailure> withdrawn(const Grant& grant) const;

  /// For a client who comes: whether its address is blocked.
  [[nodiscard]] std::optional<BlockedAddress> meet(const asio::ip::address& address) const;
  [[nodiscard]] bool blocks(const asio::ip::address& address) const;

  /// Reads the key files and the lists of revoked tokens and of blocked flows again; where the lists are now
  /// is taken from `settings`. Of keys, revoked tokens and blocked flows what cannot be read stays as it was,
  /// and the error is one line that says why; the others are as their files say. Else the value is one line
  /// for the log, warnings about the files included. From one thread.
  [[nodiscard]] tl::expected<std::string, std::string> reload(const Access& settings);

 private:
  [[nodiscard]] std::shared_ptr<const Keys> keys() const;

  Access settings_;  // but for reload() nobody looks at the lists' paths
  const Rights secret_rights_;
  mutable std::mutex mutex_;
  std::shared_ptr<const Keys> keys_;
  std::atomic<bool> anybody_reads_;
};

}  // namespace talus::server
