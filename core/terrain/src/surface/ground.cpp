#include "surface/ground.h"

#include <algorithm>

namespace talus::terrain {

Ground::Ground(const World& world, InstructionSet set, bool places) : kernels_{column_kernels(set)} {
  Surface surface = surface_of(world.spec());
  if (!places) surface.places.reset();
  rows_ = make_surface_rows(surface, set);
  if (!surface.places) return;
  quantities_.resize(surface.places->quantities);
  places_.emplace(surface.places, world.sea_fx().value_or(0),
                  static_cast<float>(world.spec().resolution * kSubvoxels), set);
}

void Ground::start(const Region& region) {
  region_ = region;
  next_ = 0;
  height_.reshape(region.width, region.depth);
  slope_.reshape(region.width, region.depth);
  xs_.clear();
  if (region.lod.value() == 0) {
    const Region around = region.expanded(1);
    for (int i = 0; i < around.width; ++i) xs_.push_back(around.x + i);
    around_.reshape(around.width, around.depth);
  } else {
    // Coarse columns lie apart: each takes the three base columns and rows around it.
    const std::int64_t step = std::int64_t{1} << region.lod.value();
    for (int i = 0; i < region.width; ++i) {
      const std::int64_t x = (region.x + i) * step;
      xs_.insert(xs_.end(), {x - 1, x, x + 1});
    }
    around_.reshape(3 * region.width, 3);
    slopes_.resize(xs_.size() - 2);
  }
  rows_->start(xs_);
  if (places_) places_->start(region.width, region.depth);
}

void Ground::compute_rows(int count) {
  const int last = std::min(region_.depth, next_ + count);
  if (region_.lod.value() == 0) {
    compute_base(next_, last);
  } else {
    compute_coarse(next_, last);
  }
  next_ = last;
  if (places_ && !pending()) places_->thin_late(slope_, nullptr);
}

// Row z has rows z to z + 2 of `around_` about it.
void Ground::compute_base(int first, int last) {
  for (int z = first == 0 ? 0 : first + 2; z < last + 2; ++z) {
    rows_->row(region_.z - 1 + z, around_.row(z).data());
    if (!places_ || z == 0 || z == region_.depth + 1) continue;
    std::copy_n(around_.row(z).begin() + 1, region_.width, height_.row(z - 1).begin());
    set_places(z - 1, region_.z - 1 + z, 1, 1);
  }
  for (int z = first; z < last; ++z) {
    std::copy_n(around_.row(z + 1).begin() + 1, region_.width, height_.row(z).begin());
    kernels_.slope(around_.row(z).data(), around_.row(z + 1).data(), around_.row(z + 2).data(),
                   static_cast<std::size_t>(region_.width), slope_.row(z).data());
  }
}

void Ground::compute_coarse(int first, int last) {
  const std::int64_t step = std::int64_t{1} << region_.lod.value();
  for (int z = first; z < last; ++z) {
    // The middle row last, as places ask for what it was made of.
    for (const int row : {0, 2, 1}) rows_->row((region_.z + z) * step + row - 1, around_.row(row).data());
    kernels_.slope(around_.row(0).data(), around_.row(1).data(), around_.row(2).data(), slopes_.size(),
                   slopes_.data());
    for (int x = 0; x < region_.width; ++x) {
      height_.at(x, z) = around_.at(3 * x + 1, 1);
      slope_.at(x, z) = slopes_[static_cast<std::size_t>(3 * x)];
    }
    if (places_) set_places(z, (region_.z + z) * step, 1, 3);
  }
}

void Ground::set_places(int z, std::int64_t base_z, std::size_t first, std::size_t step) {
  rows_->quantities(base_z, quantities_);
  places_->set_row(z, quantities_, first, step, height_.row(z));
}

}  // namespace talus::terrain
