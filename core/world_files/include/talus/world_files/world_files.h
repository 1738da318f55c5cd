// Reads files named in a spec: height maps (greyscale PNG, and two-axis NumPy arrays of numbers) and models
// (.vox, as written by MagicaVoxel).
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
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
/// Returns the models of a .vox file in its order, as MagicaVoxel shows them: turned by the scene graph, and
/// with colours by their numbers in the editor's palette; positions are ignored. Empty and hidden models are
/// passed over, unless there are no others. An error is one line.
[[nodiscard]] tl::expected<std::vector<terrain::VoxelModel>, std::string> decode_vox(
    std::span<const std::byte> bytes, const ModelBounds& bounds = {});

/// The kinds of file that a spec names.
enum class FileKind : std::uint8_t { height_map, model };
/// Takes the bytes of a file, by its name in the spec, after it was decoded.
using TakeFile = std::function<void(FileKind kind, const std::string& name, std::string&& bytes)>;

/// For World::parse(): names in a spec are relative to the folder of the spec's file. `take`, if not empty,
/// is given every file that was read.
[[nodiscard]] terrain::WorldFiles beside(const std::filesystem::path& world_file, const TakeFile& take = {});

/// Returns the bytes of a file by its name in a spec, or why there are none, in one line.
using BytesOfFile = std::function<tl::expected<std::vector<std::byte>, std::string>(const std::string& name)>;
/// The files of beside(), not decoded.
[[nodiscard]] BytesOfFile bytes_beside(const std::filesystem::path& world_file);

}  // namespace talus::world_files
