// Reads and writes the voxels and payloads of single chunks as files.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <talus/tools/failure.h>
#include <talus/voxel/chunk.h>

namespace talus::tools {

/// Reads the voxels of F.npy, 32 x 32 x 32 uint8 or uint16 in the order [y][z][x], or of F.vox, a MagicaVoxel
/// model of at most 32 voxels a side. The model's x is east, its y north and its z up; it is placed at the
/// chunk's lowest, western, northern corner. Palette indices are material ids; the rest is air.
[[nodiscard]] Expected<Chunk> read_voxels(const std::string& path);

/// Reads a file of at most kMaxPayloadBytes.
[[nodiscard]] Expected<std::vector<std::byte>> read_payload(const std::string& path);

/// Writes an array [y][z][x]: uint8, or uint16 if a material id is above 255.
[[nodiscard]] Expected<void> write_voxels(const Chunk& chunk, const std::string& path);

[[nodiscard]] Expected<void> write_payload(std::span<const std::byte> payload, const std::string& path);

/// Size of the voxels compressed by zstd at level 3: one byte per voxel if all ids fit, otherwise two.
[[nodiscard]] std::size_t zstd_bytes(const Chunk& chunk);

}  // namespace talus::tools
