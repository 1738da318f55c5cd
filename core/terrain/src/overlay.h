// Overlays: in each column of a chunk one interval becomes another material, which planes cannot represent.
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

/// In columns with from < to, voxels from..to - 1 become `material`; other columns are unchanged.
struct Overlay {
  MaterialId material{};
  ChunkPlane from{};
  ChunkPlane to{};
};

/// Applies the overlay to `layers`, which must be ordered and may exceed Layers::kMaxMaterials before and
/// after. The result has no plane equal to the one below it and no adjacent layers of one material. An
/// overlay inside one layer costs two planes.
void apply(const Overlay& overlay, Layers& layers);

/// Writes the overlay to a chunk's voxels.
void write(const Overlay& overlay, std::span<MaterialId, kChunkVolume> voxels);

/// The chunk of `layers` with all overlays applied in order; dense if the boundary view cannot hold it.
[[nodiscard]] Chunk chunk_with(Layers layers, std::span<const Overlay> overlays);

}  // namespace talus::terrain
