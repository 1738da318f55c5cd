// The method as the thesis tells it, column by column and voxel by voxel, with no thought of speed. It shares
// the types, the lattice's hashes and the sequence of layers with core/terrain, and strata() draws its noise
// there, since fbm(), the textbook's, agrees with that to float rounding and not to the bit.
#pragma once

#include <cstdint>
#include <vector>

#include <talus/terrain/erosion.h>
#include <talus/terrain/fbm.h>
#include <talus/terrain/field.h>
#include <talus/terrain/surface.h>
#include <talus/terrain/world.h>
#include <talus/voxel/material.h>

namespace talus::test::reference {

/// Perlin fBm at one point, in double; at (x + past_x, z + past_z), columns.
[[nodiscard]] double fbm(const terrain::Fbm& noise, std::int64_t x, std::int64_t z, double past_x = 0,
                         double past_z = 0);

/// What takes fBm's place in a ridged surface: Musgrave's ridged multifractal, 0 to 1, less 1/2.
[[nodiscard]] double ridges(const terrain::Fbm& noise, double feedback, std::int64_t x, std::int64_t z);

/// And in a warped one: fBm where two other noises say.
[[nodiscard]] double warped(const terrain::Surface& surface, std::int64_t x, std::int64_t z);

/// A height map's mirrored or drowned plane at one column, in subvoxels, by the textbook's cubic; not cut
/// off.
[[nodiscard]] double height_map(const terrain::PlacedMap& map, std::int64_t x, std::int64_t z);

/// Section 3.1: clamp(0.5 + gain * noise, 0, 1)^exponent * amplitude in subvoxels, for noise as it came out.
[[nodiscard]] double surface_fx(const terrain::WorldSpec& spec, double noise);

/// Equation 1 at one column that has eight neighbours.
[[nodiscard]] std::int32_t slope(const terrain::Field& heights, int x, int z);

/// Section 3.6: at any unstable column, remove what is needed to come to rest against its smallest
/// neighbour; until nothing moves.
void remove_until_stable(terrain::Field& thickness, std::int32_t repose_fx);

/// One column's stack at the region's level, as (material, top in subvoxels) from the bottom up.
struct Layer {
  MaterialId material{};
  std::int32_t top_fx = 0;
};
using Stack = std::vector<Layer>;

/// Section 3.4 at one base column of height `height_fx`: layers piled up from y = 0 until they pass it, the
/// last one cut, neighbours of one material as one.
[[nodiscard]] Stack strata(const terrain::World& world, std::int64_t x, std::int64_t z,
                           std::int32_t height_fx);

/// Section 3.6, insertion: `thickness[m]` of each loose material at the top of `stack`, which gives way.
[[nodiscard]] Stack insert(const terrain::World& world, const Stack& stack,
                           const std::vector<std::int32_t>& thickness);

/// Section 3.5, one step with virtual pipes: every column puts into eight pipes what it gives away, last
/// column first, and all pipes empty at once.
void erode_step(const std::vector<terrain::LooseRules>& rules, terrain::Neighbours neighbours,
                terrain::LooseGround& ground);

/// Section 3.7: what the voxel in row y of a column is made of, at LOD 0 and above.
[[nodiscard]] MaterialId voxel(const terrain::World& world, const Stack& stack, std::int64_t y, Lod lod);

}  // namespace talus::test::reference
