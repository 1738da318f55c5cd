// From a world to the stacks of a region: the whole method (docs/DESIGN.md). All results are pure functions
// of world and region, whatever was generated before; free functions may be called from any thread.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <talus/terrain/cave_air.h>
#include <talus/terrain/erosion.h>
#include <talus/terrain/field.h>
#include <talus/terrain/ground_cache.h>
#include <talus/terrain/objects.h>
#include <talus/terrain/stacks.h>
#include <talus/terrain/world.h>
#include <talus/voxel/coords.h>
#include <talus/voxel/material.h>

namespace talus::terrain {

/// Every intermediate result of the method over one region, for exports, pictures and tests. All fields
/// are width x depth of the region, in subvoxels of the region's level.
struct Terrain {
  Region region;
  Field surface;  // H; with the erosion method as it is after erosion
  Field bare;     // the ground before talus aprons raise it; H where there are none
  Field slope;    // eq. 1, rise over a run of one column, before erosion
  std::vector<MaterialId> strata_materials;  // bottom up, neighbours of one material merged
  std::vector<Field> strata;                 // tops of all planes, cut at H; the last equals H
  std::vector<Field> loose;                  // settled thickness, in the order of World::loose()
  std::vector<Field> place;           // t(x, z) of each: what a place allows before the slope takes its part
  std::vector<PlacedObject> objects;  // whose voxels may lie over the region
  std::vector<LookField> looks;       // of each column, by each of PlacesSpec::looks
  CaveAir caves;                      // not cut out of surface and strata, but for erosion's entrances
};

/// Halo columns of surface around a region at `lod`: max over the loose materials of ceil(t_l / c); with the
/// erosion method two for every step, since what a column receives depends on its neighbours' neighbours; as
/// many as a feature reads, if those are more.
[[nodiscard]] int halo_columns(const World& world, Lod lod);

/// The method for one world after another region, with the memory of the one before: after the first regions
/// of a size nothing more is allocated, but for a cache. For one thread at a time; the world must outlive it.
class Generator {
 public:
  /// `cache`: of ground of this world, which other generators may share; or null.
  explicit Generator(const World& world, std::shared_ptr<GroundCache> cache = nullptr);
  ~Generator();
  Generator(Generator&&) noexcept;
  Generator& operator=(Generator&&) noexcept;

  /// Exactly what the endless plane has over the region, which may be of any size that fits memory, anywhere
  /// with |base column| <= 2^36 + 2^16. What `terrain` and `stacks` held before is overwritten.
  void generate(const Region& region, Terrain& terrain);
  void generate(const Region& region, Stacks& stacks);

  /// The same in pieces, for a caller who holds a clock and may stop between two of them:
  ///
  ///     generator.start(region, std::move(stacks));
  ///     while (generator.step()) { /* go on, come back later, or never */ }
  ///     stacks = generator.take();
  ///
  /// The result does not depend on the pieces. `memory` is overwritten. Whatever is called next but step()
  /// and take() ends the work, and so does the destructor. After a std::bad_alloc only that may be called.
  void start(const Region& region, Stacks memory = {});
  /// One piece: some rows of ground, or one pass over the region with its halo: a material that settles, a
  /// material of a step of erosion, a layer of strata; or some rows of objects. About as long as `columns`
  /// columns of ground take, or a pass. False when nothing is left. REQUIRES columns > 0.
  bool step(int columns = kColumnsAPiece);
  static constexpr int kColumnsAPiece = 4096;
  /// What start() began, once step() has returned false.
  [[nodiscard]] Stacks take();

  /// With a halo of `halo` columns instead of the theorem's; for the test that shows what a smaller one
  /// breaks. 1 <= halo.
  void generate_with_halo(const Region& region, int halo, Terrain& terrain);

  /// The erosion method on a map that ends at the region's edges, until nothing moves any more (thesis 3.5),
  /// whatever method the world has. How many steps it took.
  std::int64_t generate_to_rest(const Region& region, Neighbours neighbours, Terrain& terrain);

 private:
  struct Scratch;

  /// Surface, slope and caves over the region, and what loose material needs of them `ring` columns around
  /// it. At most `halo` columns around are read for features.
  void compute_ground(const Region& region, int ring, int halo);
  void start_ground(const Region& region, int ring, int halo);
  /// Each of these does one piece, and returns false where none is left.
  bool step_ground(int columns);
  bool step_loose();
  bool step_erosion();
  /// The slope over the region and `ring` columns around it; entrances are too steep for anything to stay.
  void find_loose_slope(int ring);
  const Field& entrances_around(int ring);
  /// Both methods leave the top of the rock in the scratch's `limit` and of each loose material above it,
  /// over the region.
  void start_loose();
  void settle(std::size_t place);
  void start_grid(const LooseSpec& loose, int ring);
  void crop_share(std::size_t rule, int ring, Field& share) const;
  [[nodiscard]] bool is_talus(std::size_t place) const;
  void cut_at_bare(Field& top) const;
  void add_aprons(Field& thickness);
  void add_aprons(Terrain& terrain);
  /// With the ring still around everything, which take_eroded() takes off.
  void set_loose_over_ground();
  void start_strata();
  void finish();
  void take_eroded(int ring, Terrain& terrain);
  void take_eroded(int ring);
  void build_strata(Terrain& terrain);
  /// `surface` lies over the region, in its level's subvoxels.
  void take_caves(int ring, const Field& surface, CaveAir& air);
  void take_surveys(std::vector<Field>& surveys);
  void take_places(Terrain& terrain);
  void take_looks(std::vector<LookField>& looks);
  /// Those of the ground that is known last.
  void start_objects(std::vector<PlacedObject>& objects);
  bool step_objects(int columns, std::vector<PlacedObject>& objects);

  const World* world_;
  std::unique_ptr<Scratch> scratch_;
};

/// A generator's work, once.
[[nodiscard]] Terrain generate_terrain(const World& world, const Region& region);
[[nodiscard]] Stacks generate_stacks(const World& world, const Region& region);

}  // namespace talus::terrain
