// The scene graph of a .vox file: how MagicaVoxel shows each model. Private to core/world_files.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace talus::world_files {

/// Quarter turns and mirrors: axis i of the result is axis from[i] of the model, backwards if reversed[i].
struct VoxRotation {
  std::array<std::uint8_t, 3> from{0, 1, 2};
  std::array<bool, 3> reversed{};
};

struct VoxPose {
  VoxRotation rotation;
  bool hidden = false;
};

class VoxScene {
 public:
  /// Takes the content of an nTRN, nGRP, nSHP or LAYR; ignores other chunks. Returns false if it is
  /// malformed.
  [[nodiscard]] bool add(std::string_view id, std::span<const std::byte> content);
  /// Must be called after the last add().
  void finish();
  /// Returns the pose of the model's first visible shape. The model is hidden if it has shapes and none is
  /// visible. Returns nullopt if the graph is a cycle, or too large.
  [[nodiscard]] std::optional<VoxPose> pose_of(std::size_t model);

 private:
  using Node = std::uint32_t;
  using Layer = std::uint32_t;
  struct Transform {
    VoxRotation rotation;
    Layer layer = 0;
    bool hidden = false;
  };
  std::optional<VoxPose> pose_of_shape(Node node);

  std::vector<std::pair<Node, Transform>> transforms_;
  std::vector<std::pair<Node, Node>> parents_;          // by child
  std::vector<std::pair<std::uint32_t, Node>> shapes_;  // by model
  std::vector<std::pair<Layer, bool>> hidden_layers_;
  std::size_t steps_ = 0;  // from nodes to their parents, over all calls
};

}  // namespace talus::world_files
