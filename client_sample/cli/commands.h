// Subcommands of talus-client, one function each. Each returns nothing, or one line describing the failure.
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

struct ConnectTarget {
  protocol::Endpoint server;
  client::Options options;
};

struct GetOptions {
  ChunkKey key;
  std::filesystem::path output;  // empty: print a summary
  double timeout_seconds = 30;   // without an answer
};
[[nodiscard]] asio::awaitable<CommandResult> get(ConnectTarget target, GetOptions options);

struct FlyOptions {
  static constexpr int kRadius = 8;
  static constexpr int kFarRadius = 48;
  double seconds = 8;
  std::optional<int> radius;           // chunks of level 0; nullopt: kRadius, or the server's limit
  std::optional<int> far_radius;       // chunks of level 0 covered by coarser ones; 0: no coarser levels
  std::optional<client::Column> from;  // nullopt: the spawn point
  std::optional<double> heading;       // degrees clockwise from north; nullopt: towards scenic land
  double height = 45;                  // voxels above the ground
  double speed = 60;                   // voxels per second
  client::Generate generate = client::Generate::automatic;
  std::filesystem::path output;  // map; may be empty
  std::filesystem::path view;    // final view of the camera; may be empty
};
[[nodiscard]] asio::awaitable<CommandResult> fly(ConnectTarget target, FlyOptions options);

struct AtOptions {
  std::vector<client::Column> columns;
  double timeout_seconds = 30;  // without an answer
};
[[nodiscard]] asio::awaitable<CommandResult> at(ConnectTarget target, AtOptions options);

struct EditOptions {
  VoxelPos from, to;            // corners of a box, both included, in any order
  std::string material;         // by name; empty: as generated
  std::string only;             // fills only voxels of this material; empty: all
  std::string subject;          // player for whom to edit; empty: the token's own subject
  double timeout_seconds = 30;  // without an answer
};
[[nodiscard]] asio::awaitable<CommandResult> edit(ConnectTarget target, EditOptions options);

struct MapOptions {
  std::optional<client::Column> center;     // nullopt: the spawn point
  std::int64_t width = 1024, depth = 1024;  // base columns
  std::filesystem::path output;
  double timeout_seconds = 30;  // without an answer
};
[[nodiscard]] asio::awaitable<CommandResult> map(ConnectTarget target, MapOptions options);

}  // namespace talus::cli
