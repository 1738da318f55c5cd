// Chunks of several levels of detail around a point, arranged for ray casting, finest first.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include <talus/client/chunk_store.h>
#include <talus/client/world_info.h>
#include <talus/voxel/coords.h>

namespace talus::cli {

/// Intersection of a ray. Coordinates are base voxels relative to Scene::origin().
struct Hit {
  double distance = 0;
  glm::dvec3 point{};
  glm::ivec3 voxel{};   // lowest corner of the voxel
  int size = 1;         // its edge: 1, 2, 4, ...
  glm::ivec3 normal{};  // of the face hit
  std::uint16_t material = 0;
};

class Scene {
 public:
  enum class Stop : std::uint8_t { at_anything, at_solid };

  /// Takes all chunks in `store`, of any level. Rays must start near `centre`.
  Scene(const client::ChunkStore& store, const std::vector<client::Material>& materials, VoxelPos centre);

  [[nodiscard]] VoxelPos origin() const { return origin_; }

  /// The first voxel along the ray that is not air (with at_solid, nor liquid), within `reach`. Unknown
  /// chunks count as air. REQUIRES: `direction` has length 1.
  [[nodiscard]] std::optional<Hit> cast(const glm::dvec3& from, const glm::dvec3& direction, double reach,
                                        Stop stop) const;

  /// True if the voxel that contains the point is solid.
  [[nodiscard]] bool solid_at(const glm::ivec3& point) const;
  [[nodiscard]] bool liquid(std::uint16_t material) const { return not_gas_[material] && !solid_[material]; }

 private:
  static constexpr std::int32_t kUnknown = -1;
  static constexpr std::size_t kMaterials = std::size_t{1} << 16U;
  using Voxels = std::array<std::uint16_t, kChunkVolume>;

  // Chunks of one level. A cell is kUnknown, an index into chunks_, or -2 - material for a uniform chunk.
  struct Level {
    int shift = 0;  // from base coordinates to chunks of this level
    glm::ivec3 low{};
    glm::ivec3 size{};
    std::vector<std::int32_t> cells;

    [[nodiscard]] std::int32_t at(const glm::ivec3& cell) const;
  };
  struct CellContent {
    const Level* level = nullptr;
    glm::ivec3 cell{};
    std::int32_t content = kUnknown;
  };

  void add_level(const client::ChunkStore& store, Lod lod);
  [[nodiscard]] CellContent find(const glm::ivec3& point) const;
  [[nodiscard]] std::uint16_t material_in(const CellContent& found, const glm::ivec3& point) const;
  [[nodiscard]] std::uint16_t voxel(const CellContent& found, const glm::ivec3& local) const;

  VoxelPos origin_;
  std::vector<bool> solid_;  // by material
  std::vector<bool> not_gas_;
  std::vector<Level> levels_;
  std::vector<Voxels> chunks_;
};

}  // namespace talus::cli
