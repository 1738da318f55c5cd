#include "features/cave_shape.h"

#include <algorithm>

#include <talus/terrain/world.h>

namespace talus::terrain {

void CaveShape::start(std::span<const std::int64_t> xs, Lod lod) {
  width_ = xs.size();
  level_ = lod.value();
  tunnels_.start(plan_.tunnels, xs);
  chambers_.start(plan_.chambers, xs);
  climb_.start(plan_.climb, xs);
}

std::int32_t CaveShape::lowest_floor_fx() const {
  const std::int32_t deepest = std::max(plan_.height_fx, plan_.chamber_height_fx) / 4;
  return std::max(kSubvoxels, plan_.low_fx - deepest);
}

bool CaveShape::row(std::int64_t z, ColumnRange within, std::int32_t* floor_fx, std::int32_t* roof_fx) {
  ColumnRange air;
  CaveNoises noises;
  if (within.first < within.last) {
    noises.tunnels = tunnels_.row(z, within.first, within.last);
    noises.chambers = chambers_.row(z, within.first, within.last);
    air = kernels_.find(plan_, noises, within);
  }
  for (std::int32_t* const row : {floor_fx, roof_fx}) {
    std::fill(row, row + air.first, 0);
    std::fill(row + air.last, row + width_, 0);
  }
  if (air.last == 0) return false;
  noises.climb = climb_.row(z, air.first, air.last);
  kernels_.shape(plan_, noises, air, level_, floor_fx, roof_fx);
  return true;
}

}  // namespace talus::terrain
