// Loads the world that the server serves.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include <talus/terrain/world.h>

#include "config/config.h"
#include "player/session/published_world.h"

namespace talus::server {

/// Height maps over this size are published only with publish_files.
inline constexpr std::size_t kMaxSmallMapBytes = std::size_t{1} << 20;

struct ServedWorld {
  std::shared_ptr<const terrain::World> world;
  std::shared_ptr<const PublishedWorld> published;  // null: not published
  /// The height map for whose size the world is not published though `publish` is "public"; else empty.
  std::string withheld;
};

/// What the operator of a published world should know.
inline constexpr std::string_view kPublicationNote =
    "publish: the world's file is public: players can learn all that is generated, such as every ore and "
    "cave, "
    "and look through rock; what players dig and build is not in it";

/// Reads a world's spec; an empty path means the built-in world. An error is one line.
[[nodiscard]] tl::expected<std::shared_ptr<const terrain::World>, std::string> load_world(
    const std::filesystem::path& file);

/// The same for the configured world, with the files for clients if it is to be published.
[[nodiscard]] tl::expected<ServedWorld, std::string> load_served_world(const Config& config);

}  // namespace talus::server
