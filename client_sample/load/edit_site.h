// The place where a group of builders digs and builds, and its expected contents. Each builder has a floor,
// half of the floors being underground, and writes its voxels in turn, so that a voxel is never written again
// before the previous write was answered. Used only by the builders' thread.
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
  static constexpr std::uint32_t kMaxBuilders = 64;  // so that floors reach the next chunk row at most

  struct Cell {
    MaterialId written{};  // by the last edit
    Time due{};            // scheduled time of that edit
    std::size_t server{};  // server to which it was first sent
    bool is_written = false;
    bool open = false;    // not answered yet
    bool certain = true;  // false if the server no longer knows the editor: the outcome is unknown
    /// True if every player must see `written` by now.
    [[nodiscard]] bool settled() const { return is_written && !open && certain; }
  };
  /// Cells of one chunk, by ascending voxel index.
  struct Part {
    ChunkCoord chunk;
    std::vector<std::pair<std::uint16_t, std::uint32_t>> cells;  // index, cell
  };

  /// `ground`: the group's place, two voxels above its ground. `building`: the material used for building.
  EditSite(const glm::dvec3& ground, std::uint32_t builders, MaterialId building);

  [[nodiscard]] std::size_t size() const { return cells_.size(); }
  [[nodiscard]] Cell& cell(std::size_t index) { return cells_[index]; }
  [[nodiscard]] std::span<const Part> parts() const { return parts_; }
  [[nodiscard]] VoxelPos voxel(std::size_t index) const;
  /// Owner of the cell: the builder's index in the group.
  [[nodiscard]] static std::uint32_t builder_of(std::size_t cell) {
    return static_cast<std::uint32_t>(cell / kFloor);
  }
  /// Material of the next edit: digs if it was built, builds if it was dug.
  [[nodiscard]] MaterialId next(std::size_t index) const;

 private:
  const VoxelPos corner_;      // lowest corner
  const std::int64_t ground_;  // row of the ground
  const MaterialId building_;
  std::vector<Cell> cells_;
  std::vector<Part> parts_;
};

}  // namespace talus::load
