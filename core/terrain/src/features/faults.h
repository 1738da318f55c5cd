// Faults in the numbers used to compute them. Private to core/terrain.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <talus/terrain/fbm.h>

#include "feature.h"
#include "features/strike.h"

namespace talus::terrain {

/// A set of nearly parallel faults, which cut the strata into blocks.
struct FaultField {
  std::uint64_t seed = 0;
  Strike strike;
  std::int64_t spacing_q16 = 0;  // distance between faults, in 2^-16 column
  std::int64_t throw_fx = 0;     // maximum offset between two blocks
  Fbm wander;
  float waviness_fx = 0;  // maximum distance of a fault from a straight line

  /// The lift of block `index`: -throw / 2 to throw / 2.
  [[nodiscard]] std::int32_t lift_fx(std::int64_t index) const;
};

/// [[faults]]: all sets of a world.
class Faults final : public Feature {
 public:
  Faults(std::vector<FaultField> sets, MaxLift max_lift)
      : sets_{std::move(sets)}, max_lift_{std::move(max_lift)} {}

  [[nodiscard]] const std::vector<FaultField>& sets() const { return sets_; }

  [[nodiscard]] Stage stage() const override { return Stage::strata; }
  void write_canonical_form(TextWriter& form) const override;
  [[nodiscard]] MaxLift max_lift() const override { return max_lift_; }
  [[nodiscard]] std::unique_ptr<Deformation> make_deformation(InstructionSet set) const override;

 private:
  std::vector<FaultField> sets_;
  MaxLift max_lift_;
};

}  // namespace talus::terrain
