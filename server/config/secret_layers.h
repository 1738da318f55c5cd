// The key of the secret layers.
#pragma once

#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "config/access/key_file.h"
#include "config/config.h"

namespace talus::server {

inline constexpr std::size_t kSecretLayersKeyBytes = 32;

/// nullopt if no layer is secret. An error is one line that begins with the setting's key.
[[nodiscard]] tl::expected<std::optional<KeyFile>, std::string> load_secret_key(const SecretLayers& settings);

}  // namespace talus::server
