// What talus-client does, a function a subcommand. Each returns nothing, or one line that says what
// failed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include <asio/awaitable.hpp>
#include <tl/expected.hpp>

#include <talus/client/options.h>
#include <talus/voxel/coords.h>

#include "endpoint.h"

namespace talus::cli {

using Outcome = tl::expected<void, std::string>;

struct Connecting {
  Endpoint server;
  client::Options options;
};

struct GetOptions {
  std::int64_t x = 0, y = 0, z = 0;  // chunks of the level
  std::int64_t lod = 0;
  std::filesystem::path output;  // empty: print a summary
};
[[nodiscard]] asio::awaitable<Outcome> get(Connecting connecting, GetOptions options);

struct FlyOptions {
  double seconds = 8;
  int radius = 8;                // chunks of level 0
  int far_radius = 48;           // chunks of level 0 out to which coarser ones are wanted; 0: none
  double height = 45;            // voxels above the ground
  double speed = 60;             // voxels a second
  std::filesystem::path output;  // map; empty: none
  std::filesystem::path view;    // what the camera saw at the end; empty: none
};
[[nodiscard]] asio::awaitable<Outcome> fly(Connecting connecting, FlyOptions options);

struct MapOptions {
  bool at_spawn = true;
  std::int64_t center_x = 0, center_z = 0;  // base columns
  std::int64_t width = 1024, depth = 1024;  // base columns
  std::filesystem::path output;
};
[[nodiscard]] asio::awaitable<Outcome> map(Connecting connecting, MapOptions options);

}  // namespace talus::cli
