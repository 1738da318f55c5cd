// A number over several seeds.
#pragma once

#include <span>

namespace talus::tools {

struct Spread {
  double mean = 0;
  double deviation = 0;  // standard, of the sample
};

/// Of one value or more; a single one deviates by 0.
[[nodiscard]] Spread spread_of(std::span<const double> values);

}  // namespace talus::tools
