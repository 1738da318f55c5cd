// Level 0's heights and slopes at the columns of a region.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <talus/terrain/field.h>

#include "kernels/columns.h"
#include "loose/aprons.h"
#include "place/place_fields.h"
#include "surface/ground_tiles.h"
#include "surface/surface_rows.h"

namespace talus::terrain {

/// Reuses its memory from region to region; not thread-safe.
class Ground {
 public:
  /// `places`: true to compute looks and shares too, if the world has any. `cache`: finds and keeps ground of
  /// the world when that pays; or null. REQUIRES `places` if there is a cache.
  Ground(const World& world, InstructionSet set, bool places = true,
         std::shared_ptr<GroundCache> cache = nullptr);

  void compute(const Region& region) {
    start(region);
    while (pending()) compute_rows(region.depth);
  }
  /// compute() in pieces.
  void start(const Region& region);
  [[nodiscard]] bool pending() const { return pending_; }
  /// REQUIRES pending() and count > 0.
  void compute_rows(int count);

  /// The height with aprons, if the world has them.
  [[nodiscard]] const Field& height() const { return aprons_ ? raised_ : height_; }
  /// The height without aprons, over the region and bare_ring() columns around it.
  [[nodiscard]] const Field& bare() const { return height_; }
  [[nodiscard]] int bare_ring() const { return margin_; }
  [[nodiscard]] const Field& slope() const { return aprons_ ? raised_slope_ : slope_; }
  /// One for each LookRules and ShareRule of the world; empty without `places`. A share is empty if it is 0
  /// in the whole region, or if no loose material uses it: use places() then.
  [[nodiscard]] std::span<const LookField> looks() const { return places_ ? places_->looks() : kNoLooks; }
  [[nodiscard]] std::span<const Field> shares() const { return places_ ? places_->shares() : kNoShares; }
  /// Null without `places`.
  [[nodiscard]] const PlaceFields* places() const { return places_ ? &*places_ : nullptr; }

 private:
  /// Columns and rows of `known_` that are computed together.
  struct Block {
    int x = 0;
    int z = 0;
    int width = 0;
    int depth = 0;
  };

  [[nodiscard]] bool caches(Lod lod) const;
  [[nodiscard]] bool coarse() const { return region_.lod.value() > 0; }
  [[nodiscard]] GroundTileKey key_of(int tile_x, int tile_z) const;
  void look_up_tiles();
  void take_tile(int tile_x, int tile_z, const GroundTilePtr& tile);
  void keep_tiles(const Block& block, int first);
  void begin(const Block& block);
  void compute_row(const Block& block, int z);
  void compute_row_by_neighbours(const Block& block, int z);
  void finish();
  void raise_aprons();
  void set_places(const Block& block, int z, std::size_t first, std::size_t step);

  static inline const std::vector<LookField> kNoLooks;
  static inline const std::vector<Field> kNoShares;

  std::unique_ptr<SurfaceRows> rows_;
  const ColumnKernels& kernels_;
  std::shared_ptr<GroundCache> cache_;
  Region asked_;
  Region region_;              // with the halo of the aprons
  Region known_;               // with one more column for slopes, or extended to whole tiles
  bool knows_slopes_ = false;  // true if the surface computes slopes at this coarse level
  bool tiled_ = false;         // true if `known_` consists of tiles and the cache is used
  bool pending_ = false;
  std::vector<Block> blocks_;  // to compute
  std::size_t block_ = 0;      // current block
  int next_ = 0;               // next row of it
  std::vector<GroundTileKey> keys_;
  std::vector<GroundTilePtr> found_;
  std::vector<std::int64_t> xs_;
  Field known_height_;
  Field known_slope_;
  Field around_;  // three rows of the base columns around coarse ones
  std::vector<std::int32_t> slopes_;
  Field height_;
  Field slope_;
  std::optional<PlaceFields> places_;
  std::optional<PlaceFields> places_of_block_;  // looks and shares of a row of the block's tiles
  std::optional<Aprons> aprons_;
  ApronNumbers apron_numbers_;  // at level 0
  int margin_ = 0;              // halo of the aprons around the region
  Field raised_, raised_slope_, cliff_, with_ring_;
  std::vector<const float*> quantities_;
};

}  // namespace talus::terrain
