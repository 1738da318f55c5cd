// Overlays: in each column of a chunk an interval becomes another material, which planes of height cannot
// hold.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <talus/voxel/chunk.h>
#include <talus/voxel/coords.h>
#include <talus/voxel/material.h>

namespace talus::terrain {

/// A row of the chunk, 0 to 32, for each column (column_index).
using ChunkPlane = std::array<std::uint8_t, kChunkArea>;

/// In columns with from < to the voxels from..to - 1 become `material`; all other columns stay.
struct Overlay {
  MaterialId material{};
  ChunkPlane from{};
  ChunkPlane to{};
};

/// Puts the overlay into `layers`, which must be in order, and may be more than Layers::kMaxMaterials before
/// and after. What comes out has no plane equal to the one below it and no neighbours of one material. An
/// overlay that stays inside one layer costs two planes.
void apply(const Overlay& overlay, Layers& layers);

/// The chunk of `layers` with all overlays in turn: dense where the boundary view cannot hold it.
[[nodiscard]] Chunk chunk_with(Layers layers, std::span<const Overlay> overlays);

}  // namespace talus::terrain
