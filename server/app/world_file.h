// Loads the world that the server serves.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include <tl/expected.hpp>

#include <talus/terrain/world.h>

namespace talus::server {

/// Reads a world's spec; an empty path means the built-in world. An error is one line.
[[nodiscard]] tl::expected<std::shared_ptr<const terrain::World>, std::string> load_world(
    const std::filesystem::path& file);

}  // namespace talus::server
