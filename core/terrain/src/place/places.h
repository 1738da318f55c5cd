// The rules for looks and shares in the numbers used to compute them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <talus/terrain/places_spec.h>
#include <talus/terrain/world.h>

namespace talus::terrain {

struct Places {
  struct Condition {
    QuantityNumber quantity = 0;
    bool above = false;
    float limit = 0;
  };
  struct Case {
    std::vector<Condition> conditions;
    std::uint8_t look = 0;
  };
  /// floor(kWholeShare * clamp((value - none) * reciprocal, 0, 1)); slope is in subvoxels.
  struct Ramp {
    QuantityNumber quantity = 0;
    float none = 0;
    float reciprocal = 0;

    /// The ramp before it is clamped to 0 and 1.
    [[nodiscard]] float at(float value) const { return (value - none) * reciprocal; }
    /// Returns `share` (of kWholeShare) after the ramp, to the bit as PlaceKernels::thin.
    [[nodiscard]] std::int32_t thinned(std::int32_t share, float value) const {
      const float unit = std::min(std::max(at(value), 0.0F), 1.0F);
      return share * static_cast<std::int32_t>(unit * static_cast<float>(kWholeShare)) / kWholeShare;
    }
  };
  struct Share {
    std::vector<Ramp> early;  // ramps of quantities known with the height
    std::vector<Ramp> late;   // ramps of slope and cliff
    std::uint64_t looks = ~std::uint64_t{0};
  };

  std::vector<std::vector<Case>> looks;  // in each list the first case that holds wins
  std::vector<Share> shares;
  float reciprocal_lapse = 0;
  std::size_t quantities = kQuantities;  // including fields
};

[[nodiscard]] Places places_of(const PlacesSpec& spec);

}  // namespace talus::terrain
