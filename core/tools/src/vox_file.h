// MagicaVoxel's .vox files: limits of the format, and layout of its chunks.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <talus/terrain/world.h>
#include <talus/tools/failure.h>
#include <glm/vec3.hpp>

#include <talus/files/atomic_file.h>

namespace talus::tools {

inline constexpr int kVoxModelSide = 256;  // maximum side of one model: a voxel's position is three bytes
inline constexpr int kVoxColours = 255;    // palette indices 1 to 255; 0 is unused
inline constexpr std::int64_t kVoxSceneSide = 2048;  // MagicaVoxel's editor accepts no wider scene

/// One voxel as stored in the file; z is up.
struct VoxVoxel {
  std::uint8_t x = 0;
  std::uint8_t y = 0;
  std::uint8_t z = 0;
  std::uint8_t colour = 0;  // 1 to 255
};

/// A box of voxels and its position in the scene.
struct VoxModel {
  glm::ivec3 size{0};    // 1 to kVoxModelSide per side
  glm::ivec3 corner{0};  // scene position of the model's voxel (0, 0, 0)
  std::string name;
  std::vector<VoxVoxel> voxels;
};

/// A .vox file of version 150 (MagicaVoxel 0.99 and later, and most importers), written model by model, so
/// that it is never in memory as a whole.
class VoxFile {
 public:
  [[nodiscard]] static Expected<VoxFile> create(const std::filesystem::path& target);

  /// Models without voxels are skipped. Fails if the file would exceed 2 GiB, the limit of its length fields.
  [[nodiscard]] Expected<void> add(const VoxModel& model);
  /// Writes scene graph and palette, then renames the file into place: colours[i] is for index i + 1, and
  /// index `glass` is transparent.
  [[nodiscard]] Expected<void> finish(std::span<const terrain::Colour> colours, std::int32_t glass);

 private:
  struct PlacedModel {
    std::string name;
    glm::ivec3 translation{0};
  };
  explicit VoxFile(files::AtomicFile file) : file_{std::move(file)} {}
  [[nodiscard]] Expected<void> append(std::span<const std::byte> bytes);

  files::AtomicFile file_;
  std::uint64_t bytes_ = 0;
  std::vector<PlacedModel> placed_;
};

}  // namespace talus::tools
