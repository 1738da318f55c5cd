// A second reading of MagicaVoxel's format, from its public description; shares nothing with the writer.
// https://github.com/ephtracy/voxel-model (MagicaVoxel-file-format-vox.txt and -vox-extension.txt)
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace vox_reader {

struct Scene {
  std::size_t models = 0;
  /// (x, y, z) of the scene, z up, to palette index.
  std::map<std::array<int, 3>, int> voxels;
  /// RGBA by palette index; index 0 means nothing.
  std::array<std::uint32_t, 256> palette{};
  /// What is said of a palette index beyond its colour.
  std::map<int, std::map<std::string, std::string>> materials;
};

/// Throws std::runtime_error with what is wrong where the bytes break the format, name a node or model
/// that is not there, leave a model out of the scene, or put two voxels in one place.
[[nodiscard]] Scene read(const std::string& bytes);

}  // namespace vox_reader
