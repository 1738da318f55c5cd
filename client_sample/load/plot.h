// Waits by percentile, drawn.
#pragma once

#include <string>
#include <vector>

#include "measure/histogram.h"

namespace talus::load {

struct Curve {
  std::string name;
  const measure::Histogram* waits = nullptr;  // at least one wait
};

/// An SVG of its own: from left to right the part of all chunks, each nine between two lines ten times rarer
/// than the nine before; upwards the wait in milliseconds, logarithmic. At most six curves.
[[nodiscard]] std::string plot(const std::string& title, const std::string& subtitle,
                               const std::vector<Curve>& curves);

}  // namespace talus::load
