// MagicaVoxel's .vox files: what the format allows, and how its chunks are laid out.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <talus/terrain/world.h>
#include <glm/vec3.hpp>

#include <talus/files/atomic_file.h>
#include "failure.h"

namespace talus::tools {

inline constexpr int kVoxModelSide = 256;  // longest side of one model: a voxel's place is three bytes
inline constexpr int kVoxColours = 255;    // palette indices 1 to 255; 0 means nothing
inline constexpr std::int64_t kVoxSceneSide = 2048;  // MagicaVoxel's editor holds no wider scene

/// One voxel as the file has it; z is up.
struct VoxVoxel {
  std::uint8_t x = 0;
  std::uint8_t y = 0;
  std::uint8_t z = 0;
  std::uint8_t colour = 0;  // 1 to 255
};

/// A box of voxels and where it stands in the scene.
struct VoxModel {
  glm::ivec3 size{0};    // 1 to kVoxModelSide a side
  glm::ivec3 corner{0};  // of the scene, at which the model's voxel (0, 0, 0) stands
  std::string name;
  std::vector<VoxVoxel> voxels;
};

/// A .vox file of version 150 (MagicaVoxel 0.99 and later, and most importers), written model by model so
/// that it never stands in memory as a whole.
class VoxFile {
 public:
  [[nodiscard]] static Expected<VoxFile> create(const std::filesystem::path& target);

  /// Models without voxels are left out. Refused where the file would pass the 2 GiB that its lengths can
  /// say.
  [[nodiscard]] Expected<void> add(const VoxModel& model);
  /// Scene graph and palette: colours[i] is that of index i + 1, and index `glass` lets light through. Then
  /// the file takes its name.
  [[nodiscard]] Expected<void> finish(std::span<const terrain::Colour> colours, std::int32_t glass);

 private:
  struct Placed {
    std::string name;
    glm::ivec3 translation{0};
  };
  explicit VoxFile(files::AtomicFile file) : file_{std::move(file)} {}
  [[nodiscard]] Expected<void> append(std::span<const std::byte> bytes);

  files::AtomicFile file_;
  std::uint64_t bytes_ = 0;
  std::vector<Placed> placed_;
};

}  // namespace talus::tools
