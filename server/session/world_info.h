// What every Welcome says about the world; made once at startup.
#pragma once

#include <string>

#include <talus/terrain/extraction.h>
#include <talus/terrain/world.h>
#include <talus/voxel/content_hash.h>
#include <talus/voxel/coords.h>

namespace talus::server {

struct WorldInfo {
  ContentHash fingerprint;
  ContentHash store_id;  // 0: nothing is kept
  std::vector<terrain::Material> materials;
  terrain::HeightRange heights;
  VoxelPos spawn;
  std::string server;  // name and version
};

}  // namespace talus::server
