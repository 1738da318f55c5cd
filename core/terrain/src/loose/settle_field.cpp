#include <talus/terrain/settle.h>

#include <algorithm>

#include "loose/settle_grid.h"

namespace talus::terrain {
namespace {

void copy_out(const SettleGrid& cells, Field& field) {
  for (int z = 0; z < field.depth; ++z) {
    cells.with_row(z, [&](const auto* row) { std::copy_n(row, field.width, field.row(z).begin()); });
  }
}

}  // namespace

Field starting_thickness(const Field& slope, std::int32_t thickness_fx, std::int32_t max_slope_fx) {
  SettleGrid cells{instruction_set()};
  cells.start(slope, thickness_fx, max_slope_fx);
  Field thickness{slope.width, slope.depth};
  copy_out(cells, thickness);
  return thickness;
}

void settle(Field& thickness, std::int32_t repose_fx) {
  SettleGrid cells{instruction_set()};
  cells.start(thickness);
  cells.settle(repose_fx);
  copy_out(cells, thickness);
}

}  // namespace talus::terrain
