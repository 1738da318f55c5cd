// Exports all intermediate results of the method as NumPy arrays, for science and for comparison.
#pragma once

#include <cstdint>
#include <filesystem>

#include <talus/terrain/field.h>
#include <talus/terrain/world.h>
#include <talus/tools/failure.h>

#include <talus/progress/progress_bar.h>
#include "land_edits.h"

namespace talus::tools {

/// An export that could exceed this is rejected before anything is generated.
inline constexpr std::uint64_t kMaxExportBytes = std::uint64_t{8} << 30;

struct ExportOptions {
  int threads = 0;       // 0: one per core
  int patch_edge = 128;  // columns; affects speed and memory, never the output
  std::uint64_t max_bytes = kMaxExportBytes;
  const LandEdits* edits = nullptr;  // applied to voxels.npy; null: no edits
};

/// Writes a region of any level into `directory`, which is created if missing. Columns and rows of voxels are
/// the level's; heights and thicknesses are in 1/256 of its voxels, as in terrain::Terrain:
///
/// - surface.npy  int32[z][x]: H, even if a cave opens to the sky; its air is in voxels.npy
/// - slope.npy    int32[z][x]: rise between base columns in 1/256 of the run, of the land that export.json
///   names as `slope_of`: before erosion, with aprons
/// - apron.npy    int32[z][x]: rise of the ground by talus aprons; absent with the erosion method, whose
///   surface differs from the aprons' result
/// - place.npy    int32[m][z][x]: t(x, z), the amount of each loose material that the place allows, before
///   the slope's share, in the order of the spec
/// - eroded.npy   int32[m][z][x]: settled thickness, with aprons, in the same order
/// - strata.npy   int32[layer][z][x]: tops of the strata before loose material is inserted, bottom up, cut at
///   the surface, which the last one equals
/// - shown.npy    uint16[plane][z][x]: id of the material that each plane shows in a column: strata as above,
///   then loose material bottom up, heaviest first, then the sea's topmost voxel
/// - fields.npy   int32[f][z][x]: quantities of the base column by PlaceSampler, times 65536, rounded to even
/// - look.npy     uint8[z][x]: the column's look, in worlds with looks
/// - objects.json in worlds with objects: objects whose foot is in the region, and from level 3 on the
///   objects that a column sees (docs/DESIGN.md, "Objects"): kind, model, variant, foot, quarter turns, hash
/// - voxels.npy   uint8[y][z][x] (uint16 if the world or its edits have ids above 255), material ids, from
///   row y0 up to the highest voxel that is not air; y0 is 0, -1 at coarse levels, or the lowest row of the
///   lowest edited chunk
/// - export.json  the world's numbers and names, and each array's shape, dtype, axes, unit and meaning
///
/// Arrays are complete before the first is renamed into place; export.json is renamed last. An apron.npy or
/// look.npy of an earlier export that this one lacks is removed. Memory: a few patches per thread; voxels are
/// written directly to their place in the file.
[[nodiscard]] Expected<void> export_region(const terrain::World& world, const terrain::Region& region,
                                           const std::filesystem::path& directory,
                                           const ExportOptions& options, ProgressBar& progress);

}  // namespace talus::tools
