// The world with the layers that only servers know.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include <talus/terrain/world.h>

#include "config/access/key_file.h"
#include "config/config.h"

namespace talus::server {

/// Returns the world with its veins drawn by `key` (load_secret_key()), or `world` itself without one. An
/// error is one line.
[[nodiscard]] tl::expected<std::shared_ptr<const terrain::World>, std::string> with_secrets(
    std::shared_ptr<const terrain::World> world, const std::optional<KeyFile>& key);

/// load_world() and with_secrets(), for commands that serve nobody.
[[nodiscard]] tl::expected<std::shared_ptr<const terrain::World>, std::string> load_secret_world(
    const std::filesystem::path& file, const SecretLayers& settings);

}  // namespace talus::server
