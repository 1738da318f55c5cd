// Reads files named in a spec: height maps (16-bit greyscale PNG, and two-axis NumPy arrays of uint16, int32
// or float32) and models (.vox, as written by MagicaVoxel).
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

/// Reads a height map; its format is detected by its first bytes, not its name. An error is one line. Rows
/// run from north (low z) to south. Sizes are checked against height_map.h before memory is allocated.
[[nodiscard]] tl::expected<terrain::HeightMap, std::string> read_height_map(
    const std::filesystem::path& file);

/// The same for bytes in memory.
[[nodiscard]] tl::expected<terrain::HeightMap, std::string> decode_height_map(
    std::span<const std::byte> bytes);

/// Maximum sizes of a file's models.
struct ModelBounds {
  int width = terrain::kMaxModelWidth;  // and depth
  int height = terrain::kMaxModelHeight;
  int models = terrain::kMaxModels;
};
/// Returns all models of a .vox file, in its order, ignoring positions in its scene graph. An error is one
/// line. Sizes are checked before memory is allocated.
[[nodiscard]] tl::expected<std::vector<terrain::VoxelModel>, std::string> decode_vox(
    std::span<const std::byte> bytes, const ModelBounds& bounds = {});

/// For World::parse(): names in a spec are relative to the folder of the spec's file.
[[nodiscard]] terrain::WorldFiles beside(const std::filesystem::path& world_file);

}  // namespace talus::world_files
