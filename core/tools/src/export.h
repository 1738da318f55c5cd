// Every intermediate result of the method as NumPy arrays, for science and for comparison.
#pragma once

#include <cstdint>
#include <filesystem>

#include <talus/terrain/field.h>
#include <talus/terrain/world.h>

#include <talus/progress/progress_bar.h>
#include "failure.h"

namespace talus::tools {

/// An export that could pass this is refused before anything is generated.
inline constexpr std::uint64_t kMaxExportBytes = std::uint64_t{8} << 30;

struct ExportOptions {
  int threads = 0;       // 0: one a core
  int patch_edge = 128;  // columns; decides speed and memory, never a byte
  std::uint64_t max_bytes = kMaxExportBytes;
};

/// Writes into `directory`, which is made where it is missing, over a region of level 0:
///
/// - surface.npy  int32[z][x], subvoxels: H, also where a cave opens to the sky; its air is in voxels.npy
/// - slope.npy    int32[z][x], subvoxels of rise over a run of one column
/// - eroded.npy   int32[m][z][x], settled thickness in subvoxels, in the order of the spec
/// - strata.npy   int32[layer][z][x], tops of the strata in subvoxels before loose material is inserted,
///                cut at the surface, the last one equal to it
/// - voxels.npy   uint8[y][z][x] (uint16 where the world has ids over 255), material ids, from y = 0 up
///                to the highest row that any column's ground or sea reaches
/// - export.json  what the arrays mean
///
/// All arrays are finished before the first takes its name, and export.json takes its name last. Memory:
/// some patches a thread; voxels go straight to their place in the file.
[[nodiscard]] Expected<void> export_region(const terrain::World& world, const terrain::Region& region,
                                           const std::filesystem::path& directory,
                                           const ExportOptions& options, ProgressBar& progress);

}  // namespace talus::tools
