// The surface "regions" at one column, written from its formulas: slow, and without rows, lines or vectors.
#pragma once

#include <cstdint>

#include "surface/regions/regions.h"

namespace talus::terrain::test::reference {

[[nodiscard]] std::int32_t region_height_fx(const Regions& regions, float highest_fx, std::int64_t x,
                                            std::int64_t z);

}  // namespace talus::terrain::test::reference
