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
#include "surface/surface_rows.h"

namespace talus::terrain {

/// Keeps its memory from region to region. For one thread at a time.
class Ground {
 public:
  /// `places`: whether looks and shares are wanted, too, where the world has any.
  Ground(const World& world, InstructionSet set, bool places = true);

  void compute(const Region& region) {
    start(region);
    while (pending()) compute_rows(region.depth);
  }
  /// The same in pieces.
  void start(const Region& region);
  [[nodiscard]] bool pending() const { return next_ < region_.depth; }
  /// REQUIRES pending() and count > 0.
  void compute_rows(int count);

  /// With its aprons, where the world has them.
  [[nodiscard]] const Field& height() const { return aprons_ ? raised_ : height_; }
  /// Without.
  [[nodiscard]] const Field& bare() const { return aprons_ ? bare_ : height_; }
  [[nodiscard]] const Field& slope() const { return aprons_ ? raised_slope_ : slope_; }
  /// One for each LookRules and each ShareRule of the world; none where they are not wanted.
  [[nodiscard]] std::span<const LookField> looks() const { return places_ ? places_->looks() : kNoLooks; }
  [[nodiscard]] std::span<const Field> shares() const { return places_ ? places_->shares() : kNoShares; }
  /// Whether that share is known to be 0 all over the region.
  [[nodiscard]] bool no_share(std::size_t i) const { return places_->none(i); }

 private:
  void compute_base(int first, int last);
  void compute_coarse(int first, int last);
  void raise_aprons();
  void set_places(int z, std::size_t first, std::size_t step);

  static inline const std::vector<LookField> kNoLooks;
  static inline const std::vector<Field> kNoShares;

  std::unique_ptr<SurfaceRows> rows_;
  const ColumnKernels& kernels_;
  Region asked_;
  Region region_;              // with what aprons need around it
  bool knows_slopes_ = false;  // the surface does, at this coarse level
  int next_ = 0;               // row of the region that is not computed yet
  std::vector<std::int64_t> xs_;
  Field around_;
  std::vector<std::int32_t> slopes_;
  Field height_;
  Field slope_;
  std::optional<PlaceFields> places_;
  std::optional<Aprons> aprons_;
  ApronNumbers apron_numbers_;  // of level 0
  int margin_ = 0;              // columns around the region that aprons are made from
  Field bare_, raised_, raised_slope_, cliff_, with_ring_, ringed_cliff_;
  std::vector<const float*> quantities_;
};

}  // namespace talus::terrain
