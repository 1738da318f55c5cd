// The world's description in every Welcome. Immutable: built once all parts, including the store, are known.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <talus/terrain/extraction.h>
#include <talus/terrain/world.h>
#include <talus/voxel/content_hash.h>
#include <talus/voxel/coords.h>

#include "player/session/published_world.h"

namespace talus::server {

struct WorldInfo {
  const ContentHash fingerprint{};
  const ContentHash store_id{};  // 0: no edits are stored
  const std::vector<terrain::Material> materials{};
  const HeightRange heights{};
  const VoxelPos spawn{};
  const std::string server{};                               // name and version
  const std::vector<std::string> looks{};                   // terrain::World::look_names()
  const std::vector<std::string> fields{};                  // terrain::place_names(), at most 256
  const std::shared_ptr<const PublishedWorld> published{};  // null: not published
  const std::string world_file{};                           // its path by HTTP; empty: not published
};

}  // namespace talus::server
