// Description of the server's world, received on joining.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <talus/voxel/content_hash.h>
#include <talus/voxel/coords.h>
#include <talus/voxel/material.h>

namespace talus::client {

enum class Phase : std::uint8_t { gas, liquid, solid };

struct Material {
  MaterialId id{};
  std::string name;
  std::uint32_t colour = 0;  // 0xRRGGBB
  Phase phase{};
};

/// Rates that a server grants per second, enforced by token buckets; 0: unlimited.
struct Rates {
  std::uint64_t chunks = 0;            // Chunk messages; further ones are delayed
  std::uint64_t bytes = 0;             // all bytes that the server sends
  std::uint64_t requests = 0;          // requests, Views and pings; further ones wait inside the client
  std::chrono::milliseconds burst{0};  // a bucket holds what its rate grants during this time
};

/// Limits of this connection; the client library stays within them by itself.
struct ServerLimits {
  std::uint32_t frame_bytes = 0;
  std::uint32_t requests_in_flight = 0;  // further get() calls wait inside the client
  std::uint32_t heights_per_request = 0;
  std::uint16_t view_horizontal_radius = 0;  // chunks
  std::uint16_t view_vertical_radius = 0;    // chunks
  std::uint32_t view_chunks = 0;             // all levels of one View together
  std::uint64_t window_bytes = 0;
  std::chrono::milliseconds idle_timeout{0};
  std::optional<Rates> session_rates;  // empty if not reported
  std::optional<Rates> address_rates;  // shared by all connections from this client's address
  bool view_horizon = false;           // true if Views may have a horizon
  bool view_base = false;              // true if the world is published: clients may make chunks themselves
};

struct WorldInfo {
  ContentHash fingerprint;  // equal fingerprints: equal voxels everywhere
  ContentHash store_id;     // revisions are comparable if store ids are equal; 0: nothing is stored
  std::vector<Material> materials;
  // Range of base voxel rows of the generated world, at most kMaxWorldRows rows. Edits may lie outside.
  std::int64_t min_y = 0;  // below this row all voxels are one rock
  std::int64_t max_y = 0;  // from this row up all voxels are air
  VoxelPos spawn;          // position of the feet: the first free voxel above dry ground
  ServerLimits limits;
  std::string server;               // name and version
  std::uint16_t protocol = 0;       // version in use
  std::vector<std::string> looks;   // biome names for ColumnPlaces::looks; the first, "": no biome
  std::vector<std::string> fields;  // names that get_places() accepts. Without support, both lists are empty

  [[nodiscard]] HeightRange heights() const { return {min_y, max_y}; }
};

}  // namespace talus::client
