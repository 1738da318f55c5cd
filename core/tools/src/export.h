// Every intermediate result of the method as NumPy arrays, for science and for comparison.
#pragma once

#include <cstdint>
#include <filesystem>

#include <talus/terrain/field.h>
#include <talus/terrain/world.h>

#include <talus/progress/progress_bar.h>
#include "failure.h"
#include "land_edits.h"

namespace talus::tools {

/// An export that could pass this is refused before anything is generated.
inline constexpr std::uint64_t kMaxExportBytes = std::uint64_t{8} << 30;

struct ExportOptions {
  int threads = 0;       // 0: one a core
  int patch_edge = 128;  // columns; decides speed and memory, never a byte
  std::uint64_t max_bytes = kMaxExportBytes;
  const LandEdits* edits = nullptr;  // which voxels.npy has; null: none
};

/// Writes into `directory`, which is made where it is missing, over a region of any level. Columns and rows
/// of voxels are the level's, heights and thicknesses 1/256 of its voxels, as terrain::Terrain has them:
///
/// - surface.npy  int32[z][x]: H, also where a cave opens to the sky; its air is in voxels.npy
/// - slope.npy    int32[z][x]: rise between base columns in 1/256 of the run, of the land that export.json
///                names as `slope_of`: before erosion, with aprons
/// - apron.npy    int32[z][x]: by how much talus aprons raised the ground; not with the erosion method, whose
///                surface is not what the aprons left
/// - place.npy    int32[m][z][x]: t(x, z), what the place allows of each loose material before the slope
/// takes
///                its share, in the order of the spec
/// - eroded.npy   int32[m][z][x]: settled thickness, with aprons, in the same order
/// - strata.npy   int32[layer][z][x]: tops of the strata before loose material is inserted, bottom up, cut at
///                the surface, the last one equal to it
/// - shown.npy    uint16[plane][z][x]: the id that each plane's material shows at a column: strata as above,
///                then loose material bottom up, which is heaviest first, then the sea's topmost voxel
/// - fields.npy   int32[f][z][x]: quantities of the base column by PlaceSampler, times 65536, rounded to even
/// - look.npy     uint8[z][x]: the column's look, in worlds with looks
/// - objects.json in worlds with objects: those whose foot is in the region, and from level 3 on those that a
///                column sees (docs/DESIGN.md, "Objects"): kind, model, variant, foot, quarter turns, hash
/// - voxels.npy   uint8[y][z][x] (uint16 where the world or its edits have ids over 255), material ids, from
///                row y0 up to the highest voxel that is not air; y0 is 0, and -1 at coarse levels, or that
///                of the lowest chunk that was edited
/// - export.json  the world's numbers, names, and of each array shape, dtype, axes, unit and meaning
///
/// All arrays are finished before the first takes its name, and export.json takes its name last. An apron.npy
/// or look.npy of an earlier export that this one does not have is removed. Memory: some patches a thread;
/// voxels go straight to their place in the file.
[[nodiscard]] Expected<void> export_region(const terrain::World& world, const terrain::Region& region,
                                           const std::filesystem::path& directory,
                                           const ExportOptions& options, ProgressBar& progress);

}  // namespace talus::tools
