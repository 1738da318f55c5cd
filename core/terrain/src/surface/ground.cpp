#include "surface/ground.h"

#include <algorithm>

namespace talus::terrain {

void Ground::compute(const Region& region) {
  height_.reshape(region.width, region.depth);
  slope_.reshape(region.width, region.depth);
  xs_.clear();
  if (region.lod.value() == 0) {
    compute_base(region);
  } else {
    compute_coarse(region);
  }
}

void Ground::compute_base(const Region& region) {
  const Region around = region.expanded(1);
  for (int i = 0; i < around.width; ++i) xs_.push_back(around.x + i);
  rows_->start(xs_);
  around_.reshape(around.width, around.depth);
  for (int z = 0; z < around.depth; ++z) rows_->row(around.z + z, around_.row(z).data());
  for (int z = 0; z < region.depth; ++z) {
    std::copy_n(around_.row(z + 1).begin() + 1, region.width, height_.row(z).begin());
    kernels_.slope(around_.row(z).data(), around_.row(z + 1).data(), around_.row(z + 2).data(),
                   static_cast<std::size_t>(region.width), slope_.row(z).data());
  }
}

// Coarse columns lie apart: each takes the three base columns and rows around it.
void Ground::compute_coarse(const Region& region) {
  const std::int64_t step = std::int64_t{1} << region.lod.value();
  for (int i = 0; i < region.width; ++i) {
    const std::int64_t x = (region.x + i) * step;
    xs_.insert(xs_.end(), {x - 1, x, x + 1});
  }
  rows_->start(xs_);
  around_.reshape(3 * region.width, 3);
  slopes_.resize(xs_.size() - 2);
  for (int z = 0; z < region.depth; ++z) {
    for (int row = 0; row < 3; ++row) rows_->row((region.z + z) * step + row - 1, around_.row(row).data());
    kernels_.slope(around_.row(0).data(), around_.row(1).data(), around_.row(2).data(), slopes_.size(),
                   slopes_.data());
    for (int x = 0; x < region.width; ++x) {
      height_.at(x, z) = around_.at(3 * x + 1, 1);
      slope_.at(x, z) = slopes_[static_cast<std::size_t>(3 * x)];
    }
  }
}

}  // namespace talus::terrain
