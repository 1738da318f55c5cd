// Mean and standard deviation of a number over several seeds.
#pragma once

#include <span>

namespace talus::tools {

struct Spread {
  double mean = 0;
  double deviation = 0;  // standard deviation of the sample
};

/// REQUIRES: at least one value. The deviation of a single value is 0.
[[nodiscard]] Spread spread_of(std::span<const double> values);

}  // namespace talus::tools
