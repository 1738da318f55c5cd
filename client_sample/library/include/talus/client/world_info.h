// What a server tells about its world when a client joins.
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

/// What a server grants a second, by token buckets; 0: no limit.
struct Rates {
  std::uint64_t chunks = 0;            // Chunk messages; those beyond come later
  std::uint64_t bytes = 0;             // of everything that the server sends
  std::uint64_t requests = 0;          // requests, Views and pings; those beyond wait inside the client
  std::chrono::milliseconds burst{0};  // a bucket holds what its rate grants in this time
};

/// What the server allows this connection; the client library keeps within it by itself.
struct ServerLimits {
  std::uint32_t frame_bytes = 0;
  std::uint32_t requests_in_flight = 0;  // more get() calls than this wait inside the client
  std::uint32_t heights_per_request = 0;
  std::uint16_t view_horizontal_radius = 0;  // chunks
  std::uint16_t view_vertical_radius = 0;    // chunks
  std::uint32_t view_chunks = 0;             // of all levels in one View
  std::uint64_t window_bytes = 0;
  std::chrono::milliseconds idle_timeout{0};
  std::optional<Rates> session_rates;  // none: the server does not tell, which one of 0.1 never does
  std::optional<Rates> address_rates;  // of all connections from this client's address together
  bool view_horizon = false;           // whether Views may have a horizon
};

struct WorldInfo {
  ContentHash fingerprint;  // worlds of one fingerprint have equal voxels everywhere
  ContentHash store_id;     // revisions of one store id may be compared; 0: nothing is stored
  std::vector<Material> materials;
  // Base voxel rows of the world as generated, at most kMaxWorldRows apart. Edits reach beyond.
  std::int64_t min_y = 0;  // below this row everything is one rock
  std::int64_t max_y = 0;  // at and above this row everything is air
  VoxelPos spawn;          // feet: the first free voxel above dry ground
  ServerLimits limits;
  std::string server;               // name and version
  std::uint16_t protocol = 1;       // the version that both speak; edits need 2
  std::vector<std::string> looks;   // what ColumnPlaces::looks count; the first is that of no look, empty
  std::vector<std::string> fields;  // that get_places() knows; both empty: a server that knows none

  [[nodiscard]] HeightRange heights() const { return {min_y, max_y}; }
};

}  // namespace talus::client
