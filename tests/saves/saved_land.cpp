#include "saved_land.h"

#include <span>

#include <catch2/catch.hpp>

#include <talus/terrain/world.h>

using namespace talus;

std::string land_toml() {
  return std::string{terrain::classic_world_toml()} +
         "\n[[placeable]]\nname = \"planks\"\ncolour = \"#8a6b3d\"\n[[placeable]]\nname = \"glass\"\n"
         "colour = \"#ddeeff\"\n";
}

saves::WorldSource land() {
  const std::string toml = land_toml();
  auto source = saves::read_world(std::as_bytes(std::span{toml}));
  REQUIRE(source);
  return *std::move(source);
}

saves::Save new_save(const std::filesystem::path& file) {
  auto save = saves::Save::create(file, land());
  INFO((save ? std::string{} : save.error().message));
  REQUIRE(save);
  return *std::move(save);
}

edits::Edit written(VoxelPos voxel, MaterialId material) {
  return {{}, {{voxel, material}}, {}, {}};
}

edits::Edit filled(VoxelPos first, VoxelPos last, MaterialId material) {
  return {{}, {}, {{first, last, material, {}}}, {}};
}
