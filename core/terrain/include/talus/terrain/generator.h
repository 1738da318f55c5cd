// From a world to the stacks of a region: the whole method (docs/DESIGN.md). All results are pure functions
// of world and region, independent of earlier calls. Free functions are thread-safe.
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

/// Every intermediate result of the method over one region, for exports, pictures and tests. All fields are
/// width x depth of the region, in subvoxels of the region's level.
struct Terrain {
  Region region;
  Field surface;                             // H; with the erosion method, after erosion
  Field bare;                                // the ground before talus aprons raise it; H without aprons
  Field slope;                               // eq. 1, rise over a run of one column, before erosion
  std::vector<MaterialId> strata_materials;  // bottom up; adjacent layers of one material are merged
  std::vector<Field> strata;                 // tops of all planes, cut at H; the last equals H
  std::vector<Field> loose;                  // settled thickness, in the order of World::loose()
  std::vector<Field> place;  // t(x, z) of each: the thickness a place allows before the slope reduces it
  std::vector<PlacedObject> objects;  // objects whose voxels may lie over the region
  std::vector<LookField> looks;       // one field for each of PlacesSpec::looks
  CaveAir caves;                      // not cut out of surface and strata, except erosion's entrances
};

/// Halo columns of surface around a region at `lod`: the maximum over the loose materials of ceil(t_l / c);
/// with the erosion method two per step, since the inflow of a column depends on its neighbours' neighbours;
/// or the number that a feature reads, if that is larger.
[[nodiscard]] int halo_columns(const World& world, Lod lod);

/// Applies the method for one world to one region after another and reuses its memory: after the first
/// regions of a size only a cache allocates. Not thread-safe; the world must outlive it.
class Generator {
 public:
  /// `cache`: ground of this world, which may be shared with other generators; or null.
  explicit Generator(const World& world, std::shared_ptr<GroundCache> cache = nullptr);
  ~Generator();
  Generator(Generator&&) noexcept;
  Generator& operator=(Generator&&) noexcept;

  /// Computes exactly what the endless plane has over the region. The region may have any size that fits in
  /// memory and lie anywhere with |base column| <= 2^36 + 2^16. Overwrites `terrain` or `stacks`.
  void generate(const Region& region, Terrain& terrain);
  void generate(const Region& region, Stacks& stacks);

  /// generate() in pieces, for a caller that may pause or stop between two pieces:
  ///
  ///     generator.start(region, std::move(stacks));
  ///     while (generator.step()) { /* go on, come back later, or never */ }
  ///     stacks = generator.take();
  ///
  /// The result does not depend on the pieces. `memory` is overwritten. Any call but step() and take()
  /// cancels the work, and so does the destructor. After a std::bad_alloc only a call that cancels the work
  /// is allowed.
  void start(const Region& region, Stacks memory = {});
  /// Does one piece: some rows of ground, or some rows of objects, or one pass over the region with its halo:
  /// the settling of a material, a material of an erosion step, a layer of strata. Takes about as long as
  /// `columns` columns of ground, or a pass. False when nothing is left. REQUIRES columns > 0.
  bool step(int columns = kColumnsAPiece);
  static constexpr int kColumnsAPiece = 4096;
  /// Returns the result of the work begun by start(). REQUIRES that step() has returned false.
  [[nodiscard]] Stacks take();

  /// Uses a halo of `halo` columns instead of the theorem's; for the test that shows the effect of a smaller
  /// halo. REQUIRES halo >= 1.
  void generate_with_halo(const Region& region, int halo, Terrain& terrain);

  /// Runs the erosion method on a map that ends at the region's edges until nothing moves (thesis 3.5),
  /// whatever the world's method. Returns the number of steps.
  std::int64_t generate_to_rest(const Region& region, Neighbours neighbours, Terrain& terrain);

 private:
  struct Scratch;

  /// Computes surface, slope and caves over the region, plus the `ring` columns around it that loose material
  /// needs. Reads at most `halo` columns around the region for features.
  void compute_ground(const Region& region, int ring, int halo);
  void start_ground(const Region& region, int ring, int halo);
  /// Each of these does one piece; false when nothing is left.
  bool step_ground(int columns);
  bool step_loose();
  bool step_erosion();
  /// Slope over the region and `ring` columns around it; entrances are too steep for material to stay.
  void find_loose_slope(int ring);
  const Field& entrances_around(int ring);
  /// Both methods leave the top of the rock in Scratch::limit and the tops of loose materials in
  /// Scratch::loose_tops, over the region.
  void start_loose();
  void settle(std::size_t place);
  void start_grid(const LooseSpec& loose, int ring);
  void crop_share(std::size_t rule, int ring, Field& share) const;
  [[nodiscard]] bool is_talus(std::size_t place) const;
  void cut_at_bare(Field& top) const;
  void add_aprons(Field& thickness);
  void add_aprons(Terrain& terrain);
  /// Fields keep the ring around the region; take_eroded() crops it.
  void set_loose_over_ground();
  void start_strata();
  void finish();
  void take_eroded(int ring, Terrain& terrain);
  void take_eroded(int ring);
  void build_strata(Terrain& terrain);
  /// `surface` covers the region, in subvoxels of its level.
  void take_caves(int ring, const Field& surface, CaveAir& air);
  void take_surveys(std::vector<Field>& surveys);
  void take_places(Terrain& terrain);
  void take_looks(std::vector<LookField>& looks);
  /// Places the objects of the ground computed last.
  void start_objects(std::vector<PlacedObject>& objects);
  bool step_objects(int columns, std::vector<PlacedObject>& objects);

  const World* world_;
  std::unique_ptr<Scratch> scratch_;
};

/// Generates one region with a temporary Generator.
[[nodiscard]] Terrain generate_terrain(const World& world, const Region& region);
[[nodiscard]] Stacks generate_stacks(const World& world, const Region& region);

}  // namespace talus::terrain
