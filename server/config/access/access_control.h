// Decides which clients may join, and with which rights.
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
#include "config/access/grant.h"
#include "config/access/key_file.h"
#include "config/access/revoked_tokens.h"
#include "config/access/rights.h"
#include "config/config.h"

namespace talus::server {

/// SHA-256 of the shared secret; the secret itself is not kept.
using SecretDigest = std::array<unsigned char, 32>;

/// Keys that verify tokens.
struct TokenKeys {
  std::optional<SecretDigest> shared_secret;
  std::vector<Secret> signing_keys;   // the current key first
  std::vector<std::string> warnings;  // about the files, one line each

  [[nodiscard]] bool any() const { return shared_secret || !signing_keys.empty(); }
};

/// Contents of the configured files; the pointers are never null.
struct Keys {
  std::shared_ptr<const TokenKeys> tokens;
  std::shared_ptr<const RevokedTokens> revoked;
  std::shared_ptr<const BlockedFlows> blocked;
  std::vector<std::string> warnings{};  // about the files, one line each

  [[nodiscard]] bool any() const { return tokens->any(); }
};

/// An error is one line that begins with the setting's key: the file is bad, or the settings admit no client.
[[nodiscard]] tl::expected<Keys, std::string> load_keys(const Access& settings);

struct AuthError {
  AuthFailure failure{};
  std::string reason;     // for the operator's log; may be empty
  bool repeated = false;  // this block was logged before
  bool signed_by_key = false;
  /// Sentence for the client: describe(), with the reason if this server's key signed the token.
  [[nodiscard]] std::string text() const;
};

/// An address blocked by a line of access.blocked_file.
struct BlockedAddress {
  std::size_t line = 0;
  bool repeated = false;  // not the first address blocked by this line since the file was read
};

/// Callable from any thread.
class AccessControl {
 public:
  /// `keys` must come from load_keys(settings).
  AccessControl(const Access& settings, Keys keys);

  /// Checks the token of a Hello (empty if the client sent none). Accepts the shared secret, and tokens
  /// signed by one of the keys. If no keys are configured, tokens are ignored.
  [[nodiscard]] tl::expected<Grant, AuthError> admit(std::string_view token,
                                                     std::chrono::sys_seconds now) const;

  /// True if clients without a token may read. Cheap, because every HTTP answer calls it.
  [[nodiscard]] bool lets_anybody_read() const { return anybody_reads_.load(std::memory_order_relaxed); }
  /// True if any token can be accepted.
  [[nodiscard]] bool has_keys() const { return keys()->any(); }

  /// Reason to end an admitted session (token revoked or subject blocked since); nullopt if it may stay.
  [[nodiscard]] std::optional<AuthFailure> withdrawn(const Grant& grant) const;

  /// Checks a connecting client's address; nullopt if it is not blocked. Marks the line as used.
  [[nodiscard]] std::optional<BlockedAddress> meet(const asio::ip::address& address) const;
  [[nodiscard]] bool blocks(const asio::ip::address& address) const;

  /// Rereads the key files and the lists of revoked tokens and blocked flows, at the paths of `settings` for
  /// the lists. Keys, revoked tokens and blocked flows are replaced separately: if one cannot be read, its
  /// old value stays, and the error is one line with the reasons. Otherwise returns one line for the log,
  /// including warnings about the files. Call from one thread only.
  [[nodiscard]] tl::expected<std::string, std::string> reload(const Access& settings);

 private:
  [[nodiscard]] std::shared_ptr<const Keys> keys() const;

  Access settings_;  // the lists' paths are used only by reload()
  const Rights secret_rights_;
  mutable std::mutex mutex_;
  std::shared_ptr<const Keys> keys_;
  std::atomic<bool> anybody_reads_;
};

}  // namespace talus::server
