// Reads the files that a spec may name: height maps (16-bit greyscale PNG, and NumPy arrays of two axes:
// uint16, int32 or float32) and models (.vox, as MagicaVoxel writes them).
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include <talus/terrain/height_map.h>
#include <talus/terrain/voxel_model.h>
#include <talus/terrain/world_files.h>

namespace talus::world_files {

/// The file's height map by its first bytes, whatever it is called; an error is one line. Rows go from north
/// (low z) to south. Sizes are checked against the bounds of height_map.h before memory is asked for.
[[nodiscard]] tl::expected<terrain::HeightMap, std::string> read_height_map(
    const std::filesystem::path& file);

/// The same of bytes in memory.
[[nodiscard]] tl::expected<terrain::HeightMap, std::string> decode_height_map(
    std::span<const std::byte> bytes);

/// What a file's models may be at most.
struct ModelBounds {
  int width = terrain::kMaxModelWidth;  // and depth
  int height = terrain::kMaxModelHeight;
  int models = terrain::kMaxModels;
};
/// All models of a .vox file, in its order; where its scene graph puts them is not read. An error is one
/// line. Sizes are checked before memory is asked for.
[[nodiscard]] tl::expected<std::vector<terrain::VoxelModel>, std::string> decode_vox(
    std::span<const std::byte> bytes, const ModelBounds& bounds = {});

/// For World::parse: names in a spec are relative to the folder of the file that holds the spec.
[[nodiscard]] terrain::WorldFiles beside(const std::filesystem::path& world_file);

}  // namespace talus::world_files
