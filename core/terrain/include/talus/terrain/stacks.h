// From a world to stacks to chunks: the whole method for a region of columns. All results are pure functions
// of world and region, whatever was generated before; free functions may be called from any thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <talus/terrain/cave_air.h>
#include <talus/terrain/erosion.h>
#include <talus/terrain/field.h>
#include <talus/terrain/world.h>
#include <talus/voxel/chunk.h>
#include <talus/voxel/coords.h>

namespace talus::terrain {

/// Every intermediate result of the method over one region, for exports, pictures and tests. All fields
/// are width x depth of the region, in subvoxels of the region's level.
struct Terrain {
  Region region;
  Field surface;                             // H; with the erosion method as it is after erosion
  Field slope;                               // eq. 1, rise over a run of one column, before erosion
  std::vector<MaterialId> strata_materials;  // bottom up, neighbours of one material merged
  std::vector<Field> strata;                 // tops of all planes, cut at H; the last equals H
  std::vector<Field> loose;                  // settled thickness, in the order of World::loose()
  CaveAir caves;  // surface and strata know nothing of it, but for erosion's entrances
};

/// The stacks of a region (thesis 2.2.3): planes bottom up, over which every column has the same list of
/// materials, with thickness 0 where one is absent. Water and air are not in it.
struct Stacks {
  Region region;
  std::vector<MaterialId> materials;  // materials[k] lies between plane k - 1 and plane k
  std::vector<Field> tops;            // subvoxels; no plane lies below the one before; the last is H
  CaveAir caves;

  /// Whether the column is a cave's entrance: no roof, and dry wherever the sea stands.
  [[nodiscard]] bool is_entrance(int x, int z) const {
    return caves.has(x, z) && caves.roof.at(x, z) >= tops.back().at(x, z);
  }
  /// Where the topmost solid material of a column ends, in subvoxels.
  [[nodiscard]] std::int32_t ground_fx(int x, int z) const {
    return is_entrance(x, z) ? caves.floor.at(x, z) : tops.back().at(x, z);
  }
  [[nodiscard]] std::size_t bytes() const;
};

/// Halo columns of surface around a region at `lod`: max over the loose materials of ceil(t_l / c); with the
/// erosion method two for every step, since what a column receives depends on its neighbours' neighbours; as
/// many as a cave's roof may reach, and one more where water is, if those are more.
[[nodiscard]] int halo_columns(const World& world, Lod lod);

/// The method for one world after another region, with the memory of the one before: after the first regions
/// of a size nothing more is allocated. For one thread at a time; the world must outlive it.
class Generator {
 public:
  explicit Generator(const World& world);
  ~Generator();
  Generator(Generator&&) noexcept;
  Generator& operator=(Generator&&) noexcept;

  /// Exactly what the endless plane has over the region, which may be of any size that fits memory, anywhere
  /// with |base column| <= 2^36 + 2^16. What `terrain` and `stacks` held before is overwritten.
  void generate(const Region& region, Terrain& terrain);
  void generate(const Region& region, Stacks& stacks);

  /// With a halo of `halo` columns instead of the theorem's; for the test that shows what a smaller one
  /// breaks. 1 <= halo.
  void generate_with_halo(const Region& region, int halo, Terrain& terrain);

  /// The erosion method on a map that ends at the region's edges, until nothing moves any more (thesis 3.5),
  /// whatever method the world has. How many steps it took.
  std::int64_t generate_to_rest(const Region& region, Neighbours neighbours, Terrain& terrain);

 private:
  struct Scratch;

  /// Surface, slope and caves over the region, and what loose material needs of them `ring` columns around
  /// it. At most `halo` columns more are read for the caves.
  void cover(const Region& region, int ring, int halo);
  /// The slope over the region and `ring` columns around it; entrances are too steep for anything to stay.
  const Field& slope_for_loose(int ring);
  /// Both methods leave the top of the rock in the scratch's `limit` and of each loose material above it,
  /// over the region.
  void settle(const Region& region);
  /// With `ring` columns still around everything, which take_eroded() takes off.
  void erode(const Region& region, int ring, int halo);
  void set_loose_over(const Region& region, int ring, int halo);
  void take_eroded(int ring, Terrain& terrain);
  void take_eroded(int ring);
  void lay_strata(Terrain& terrain);
  /// `surface` lies over the region, in its level's subvoxels.
  void take_caves(int ring, const Field& surface, CaveAir& air);

  const World* world_;
  std::unique_ptr<Scratch> scratch_;
};

/// A generator's work, once.
[[nodiscard]] Terrain generate_terrain(const World& world, const Region& region);
[[nodiscard]] Stacks generate_stacks(const World& world, const Region& region);

/// The chunk `coord` of the region's level. Its 32 x 32 columns must lie inside stacks.region (asserted). It
/// is made in the memory of `memory`, whatever that holds: with that of chunks before (Chunk::take_layers)
/// only what is missing is allocated, and more where caves, ores or too many layers for the boundary view
/// are.
[[nodiscard]] Chunk extract_chunk(const World& world, const Stacks& stacks, ChunkCoord coord,
                                  Layers memory = {});

/// The ore that each column of the region has at the top of its rock, or in the floor of a cave that is open
/// to the sky, kAir where it has none; z slowest. It is what shows on ground where no loose material lies.
[[nodiscard]] std::vector<MaterialId> surface_ore(const World& world, const Stacks& stacks);

/// Chunk rows [first, last] outside which every chunk over these 32 x 32 columns is uniform: `below` under
/// them, air above.
struct MixedRange {
  std::int32_t first = 0;
  std::int32_t last = 0;  // first - 1 where no chunk is mixed
  MaterialId below{};
};
[[nodiscard]] MixedRange mixed_range(const World& world, const Stacks& stacks, std::int32_t chunk_x,
                                     std::int32_t chunk_z);

/// The same for every column of a level, whatever the surface does. Costs nothing.
[[nodiscard]] MixedRange mixed_range(const World& world, Lod lod);

/// The material of a chunk that is uniform whatever the surface does: all below the lowest or above the
/// highest that this world can have. Costs nothing.
[[nodiscard]] std::optional<MaterialId> uniform_everywhere(const World& world, ChunkKey key);

/// The row of voxels of a level at and above which all is air.
[[nodiscard]] std::int64_t highest_row(const World& world, Lod lod);

/// Rows of base voxels between which everything but plain rock and air lies, at every level: below `low` all
/// is the first layer's material, at and above `high` all is air.
struct HeightRange {
  std::int64_t low = 0;
  std::int64_t high = 0;
};
[[nodiscard]] HeightRange height_range(const World& world);

/// One chunk alone, from scratch.
[[nodiscard]] Chunk generate_chunk(const World& world, ChunkKey key);

/// The ground of single base columns, in subvoxels: H, or a cave's floor where it is open to the sky. With
/// the erosion method each tile of 32 x 32 columns that is asked into costs a region of its own with its
/// halo.
struct BaseColumn {
  std::int64_t x = 0;
  std::int64_t z = 0;
};
[[nodiscard]] std::vector<std::int32_t> surface_heights(const World& world,
                                                        std::span<const BaseColumn> columns);

/// A dry, level place near the origin: the voxel in which feet stand, the first free one above the ground.
/// Where no ground is dry within reach, on the water.
[[nodiscard]] VoxelPos find_spawn(const World& world);

}  // namespace talus::terrain
