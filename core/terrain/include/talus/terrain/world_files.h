// Access of World::parse to the files that a spec names. core/world_files implements it.
#pragma once

#include <concepts>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include <talus/terrain/height_map.h>
#include <talus/terrain/voxel_model.h>

namespace talus::terrain {

/// Each loads the file that a spec names as `file`, or returns a one-line error. If the function is empty, a
/// spec that names such a file is rejected.
using LoadHeightMap = std::function<tl::expected<HeightMap, std::string>(const std::string& file)>;
/// Returns 1 to kMaxModels models, each at most kMaxModelWidth x kMaxModelHeight x kMaxModelWidth, with all
/// voxels inside their model.
using LoadModels = std::function<tl::expected<std::vector<VoxelModel>, std::string>(const std::string& file)>;

struct WorldFiles {
  WorldFiles() = default;
  /// For programs that load only height maps.
  template <std::convertible_to<LoadHeightMap> Load>
  WorldFiles(const Load& load_height_map) : height_map{load_height_map} {}  // NOLINT: on purpose
  WorldFiles(LoadHeightMap load_height_map, LoadModels load_models)
      : height_map{std::move(load_height_map)}, models{std::move(load_models)} {}

  LoadHeightMap height_map;
  LoadModels models;
};

}  // namespace talus::terrain
