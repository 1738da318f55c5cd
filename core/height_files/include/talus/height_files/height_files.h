// Reads height maps: 16-bit greyscale PNG, and NumPy arrays of two axes (uint16, int32 or float32).
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include <tl/expected.hpp>

#include <talus/terrain/height_map.h>

namespace talus::height_files {

/// The file's height map by its first bytes, whatever it is called; an error is one line. Rows go from north
/// (low z) to south. Sizes are checked against the bounds of height_map.h before memory is asked for.
[[nodiscard]] tl::expected<terrain::HeightMap, std::string> read_height_map(
    const std::filesystem::path& file);

/// The same of bytes in memory.
[[nodiscard]] tl::expected<terrain::HeightMap, std::string> decode_height_map(
    std::span<const std::byte> bytes);

/// For World::parse: names in a spec are relative to the folder of the file that holds the spec.
[[nodiscard]] terrain::LoadHeightMap beside(const std::filesystem::path& world_file);

}  // namespace talus::height_files
