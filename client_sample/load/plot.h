// Draws waits by percentile.
#pragma once

#include <string>
#include <vector>

#include "measure/histogram.h"

namespace talus::load {

struct Curve {
  std::string name;
  const measure::Histogram* waits = nullptr;  // at least one wait
};

/// Returns a self-contained SVG: rightwards the share of all chunks, with equal space for each further nine;
/// upwards the wait in milliseconds, logarithmic. At most six curves.
[[nodiscard]] std::string plot(const std::string& title, const std::string& subtitle,
                               const std::vector<Curve>& curves);

}  // namespace talus::load
