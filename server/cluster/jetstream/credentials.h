// This server's credentials for NATS, read from the files that [cluster] names.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "config/access/key_file.h"
#include "config/config.h"

namespace talus::server::jetstream {

/// At most one of password, token and seed is set.
struct Credentials {
  std::string user;
  std::optional<Secret> password{};
  std::optional<Secret> token{};
  std::optional<Secret> seed{};  // an NKey's
  std::string public_key{};      // derived from the seed
  bool tls = false;
  std::string ca{};                     // PEM
  std::string certificate{};            // PEM; may be empty
  std::optional<Secret> key{};          // PEM
  std::vector<std::string> warnings{};  // for the log, one line each

  /// True if secrets are in memory.
  [[nodiscard]] bool any() const { return password || token || seed || key; }
};

/// `cluster` must have passed check_cluster(). An error is one line that begins with a key.
[[nodiscard]] tl::expected<Credentials, std::string> load_credentials(const Cluster& cluster);

}  // namespace talus::server::jetstream
