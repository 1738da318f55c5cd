// What talus-client does, a function a subcommand. Each returns nothing, or one line that says what
// failed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <asio/awaitable.hpp>
#include <tl/expected.hpp>

#include <talus/client/client.h>
#include <talus/protocol/endpoint.h>
#include <talus/voxel/coords.h>

namespace talus::cli {

using CommandResult = tl::expected<void, std::string>;

struct Connecting {
  protocol::Endpoint server;
  client::Options options;
};

struct GetOptions {
  ChunkKey key;
  std::filesystem::path output;  // empty: print a summary
  double timeout_seconds = 30;   // without an answer
};
[[nodiscard]] asio::awaitable<CommandResult> get(Connecting connecting, GetOptions options);

struct FlyOptions {
  static constexpr int kRadius = 8;
  static constexpr int kFarRadius = 48;
  double seconds = 8;
  std::optional<int> radius;  // chunks of level 0; none: kRadius, or what the server allows
  std::optional<int>
      far_radius;  // chunks of level 0 out to which coarser ones are wanted; 0: no coarser ones
  std::optional<client::Column> from;  // none: the spawn point
  std::optional<double> heading;       // degrees clockwise from north; none: where the land is worth it
  double height = 45;                  // voxels above the ground
  double speed = 60;                   // voxels a second
  std::filesystem::path output;        // map; empty: none
  std::filesystem::path view;          // what the camera saw at the end; empty: none
};
[[nodiscard]] asio::awaitable<CommandResult> fly(Connecting connecting, FlyOptions options);

struct AtOptions {
  std::vector<client::Column> columns;
  double timeout_seconds = 30;  // without an answer
};
[[nodiscard]] asio::awaitable<CommandResult> at(Connecting connecting, AtOptions options);

struct EditOptions {
  VoxelPos from, to;            // corners of a box, both included, in any order
  std::string material;         // by name; empty: as generated
  std::string only;             // voxels of other materials stay; empty: of any
  std::string subject;          // for whom it is edited; empty: for the token's own subject
  double timeout_seconds = 30;  // without an answer
};
[[nodiscard]] asio::awaitable<CommandResult> edit(Connecting connecting, EditOptions options);

struct MapOptions {
  std::optional<client::Column> center;     // none: the spawn point
  std::int64_t width = 1024, depth = 1024;  // base columns
  std::filesystem::path output;
  double timeout_seconds = 30;  // without an answer
};
[[nodiscard]] asio::awaitable<CommandResult> map(Connecting connecting, MapOptions options);

}  // namespace talus::cli
