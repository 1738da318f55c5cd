// Who may come in, and what they may do there.
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

#include "access/denial.h"
#include "access/key_file.h"
#include "access/rights.h"
#include "config/config.h"

namespace talus::server {

/// SHA-256 of the shared secret: the secret itself is not kept.
using SecretDigest = std::array<unsigned char, 32>;

/// What the key files of the configuration hold.
struct Keys {
  std::optional<SecretDigest> shared_secret;
  std::vector<Secret> signing_keys;   // the present one first
  std::vector<std::string> warnings;  // lines about the files

  [[nodiscard]] bool any() const { return shared_secret || !signing_keys.empty(); }
};

/// An error is one line that names the setting and the file, or the settings that leave nobody a way in.
[[nodiscard]] tl::expected<Keys, std::string> load_keys(const Access& settings);

/// What a session got by its token.
struct Grant {
  Rights rights{Right::read};
  std::string subject;                              // of a signed token, as it came: escape before logging
  std::optional<std::chrono::sys_seconds> expires;  // the session ends then, and kClockSkew later at most
};

struct Denied {
  Denial denial{};
  std::string why;  // for the operator's log; empty where describe() says all
};

/// Callable from any thread.
class AccessControl {
 public:
  /// `keys` as load_keys(settings) gave them.
  AccessControl(const Access& settings, Keys keys);

  /// What a Hello with this token may do; an empty token is none. Whoever has the shared secret or a
  /// signing key is let in; where there is neither, a token means nothing and nobody needs one.
  [[nodiscard]] tl::expected<Grant, Denied> admit(std::string_view token, std::chrono::sys_seconds now) const;

  /// Reads the key files again. Who is in stays; where a file is bad the old keys stay, all of them. The line
  /// says which, and is an error in the latter case. It has warnings about the files, too.
  [[nodiscard]] tl::expected<std::string, std::string> reload();

 private:
  [[nodiscard]] std::shared_ptr<const Keys> keys() const;

  const Access settings_;
  const Rights secret_rights_;
  mutable std::mutex mutex_;
  std::shared_ptr<const Keys> keys_;
};

}  // namespace talus::server
