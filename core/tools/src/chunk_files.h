// Single chunks as files: their voxels, and their payloads.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <talus/voxel/chunk.h>

#include "failure.h"

namespace talus::tools {

/// The voxels of F.npy, 32 x 32 x 32 uint8 or uint16 in the order [y][z][x], or of F.vox, one MagicaVoxel
/// model of at most 32 voxels a side: its x is east, its y north and its z up; it stands in the chunk's
/// lowest, western, northern corner, palette indices are material ids and all else is air.
[[nodiscard]] Expected<Chunk> read_voxels(const std::string& path);

/// The bytes of a file of at most kMaxPayloadBytes.
[[nodiscard]] Expected<std::vector<std::byte>> read_payload(const std::string& path);

/// An array [y][z][x]: uint8, or uint16 where a material id is above 255.
[[nodiscard]] Expected<void> write_voxels(const Chunk& chunk, const std::string& path);

[[nodiscard]] Expected<void> write_payload(std::span<const std::byte> payload, const std::string& path);

/// The bytes that zstd at level 3 makes of the voxels: one byte a voxel where all ids fit, else two.
[[nodiscard]] std::size_t zstd_bytes(const Chunk& chunk);

}  // namespace talus::tools
