// Where a group of builders digs and builds, and what must be there then. Each has a floor of its own, half
// of the floors below the ground, and writes its voxels in turn, so that a voxel is never written again
// before its last write was answered. Of one thread, that of its builders.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include <talus/voxel/chunk.h>

#include "pending_chunks.h"

namespace talus::load {

class EditSite {
 public:
  static constexpr std::int64_t kEdge =
      16;  // voxels of a floor along x and z; it lies in one chunk's columns
  static constexpr std::size_t kFloor = kEdge * kEdge;
  static constexpr std::uint32_t kMaxBuilders =
      64;  // so that floors reach into the next chunk row and no farther

  struct Cell {
    MaterialId written{};  // by the last edit
    Time due{};            // when that was to be sent
    std::size_t server{};  // which of them it was first sent to
    bool is_written = false;
    bool open = false;    // it is not answered yet
    bool certain = true;  // nobody knows where not: the server has forgotten who sent it
    /// Whether all must see `written` by now.
    [[nodiscard]] bool settled() const { return is_written && !open && certain; }
  };
  /// Cells of one chunk, by the voxels' rising indices.
  struct Part {
    ChunkCoord chunk;
    std::vector<std::pair<std::uint16_t, std::uint32_t>> cells;  // index, cell
  };

  /// `ground`: the group's place, two voxels above its ground. `building`: what they build of.
  EditSite(const glm::dvec3& ground, std::uint32_t builders, MaterialId building);

  [[nodiscard]] std::size_t size() const { return cells_.size(); }
  [[nodiscard]] Cell& cell(std::size_t index) { return cells_[index]; }
  [[nodiscard]] std::span<const Part> parts() const { return parts_; }
  [[nodiscard]] VoxelPos voxel(std::size_t index) const;
  /// Whose the cell is, counted in the group.
  [[nodiscard]] static std::uint32_t builder_of(std::size_t cell) {
    return static_cast<std::uint32_t>(cell / kFloor);
  }
  /// What the next edit there writes: it digs where it built, and builds where it dug.
  [[nodiscard]] MaterialId next(std::size_t index) const;

 private:
  const VoxelPos corner_;      // the lowest
  const std::int64_t ground_;  // the row of the ground
  const MaterialId building_;
  std::vector<Cell> cells_;
  std::vector<Part> parts_;
};

}  // namespace talus::load
