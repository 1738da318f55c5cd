// Worlds of libtalus-local that go away with their test.
#pragma once

#include <talus_local.h>

#include <memory>
#include <string>

#include <catch2/catch.hpp>

struct CloseWorld {
  void operator()(talus_local_world* world) const { talus_world_close(world); }
  void operator()(talus_workspace* workspace) const { talus_workspace_destroy(workspace); }
};
using LocalWorld = std::unique_ptr<talus_local_world, CloseWorld>;
using Workspace = std::unique_ptr<talus_workspace, CloseWorld>;

/// "" is the built-in world.
inline LocalWorld open_world(const std::string& toml, std::uint32_t flags = 0) {
  talus_world_options options{};
  options.size = sizeof options;
  options.flags = flags;
  options.toml = toml.empty() ? nullptr : toml.c_str();
  options.toml_bytes = toml.size();
  talus_local_world* world = nullptr;
  const talus_status opened = talus_world_open(&options, &world);
  INFO(talus_local_error());
  REQUIRE(opened == TALUS_OK);
  return LocalWorld{world};
}

inline Workspace workspace_of(const LocalWorld& world) {
  talus_workspace* workspace = nullptr;
  REQUIRE(talus_workspace_create(world.get(), 0, &workspace) == TALUS_OK);
  return Workspace{workspace};
}

inline talus_world_info info_of(const LocalWorld& world) {
  talus_world_info info{};
  info.size = sizeof info;
  REQUIRE(talus_world_get_info(world.get(), &info) == TALUS_OK);
  return info;
}

/// A world that is quick to open, with planks to place.
inline const std::string kFlat = R"(
seed = 7
resolution = 4
strata_wavelength = 16
[surface]
wavelength = 64
octaves = 3
gain = 1
exponent = 1
amplitude = 16
[[stratified]]
name = "stone"
colour = "#808080"
depth = 0
thickness = 4
roughness = 0
[[eroded]]
name = "soil"
colour = "#604020"
weight = 1
thickness = 0.25
angle_of_repose = 35
max_slope = 60
[[placeable]]
name = "planks"
colour = "#8a6b3d"
)";
