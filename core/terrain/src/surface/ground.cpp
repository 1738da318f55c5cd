#include "surface/ground.h"

#include <algorithm>

namespace talus::terrain {

Ground::Ground(const World& world, InstructionSet set, bool places) : kernels_{column_kernels(set)} {
  Surface surface = surface_of(world.spec());
  if (!places) surface.places.reset();
  rows_ = make_surface_rows(surface, set);
  if (world.spec().talus) {
    aprons_.emplace(set);
    apron_numbers_ = apron_numbers(world);
  }
  if (!surface.places) return;
  quantities_.resize(surface.places->quantities);
  places_.emplace(surface.places, world.sea_fx().value_or(0),
                  static_cast<float>(world.spec().resolution * kSubvoxels), set);
}

void Ground::start(const Region& asked) {
  asked_ = asked;
  // One column more, so that the slope of what is raised is known.
  margin_ = aprons_ ? apron_halo(at_level(apron_numbers_, asked.lod)) + 1 : 0;
  const Region region = asked.expanded(margin_);
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
    const std::int64_t step = std::int64_t{1} << region.lod.value();
    for (int i = 0; i < region.width; ++i) xs_.push_back((region.x + i) * step);
    knows_slopes_ = rows_->starts_level(xs_, region.lod);
    if (!knows_slopes_) {
      // Each takes the three base columns and rows around it.
      xs_.clear();
      for (int i = 0; i < region.width; ++i) {
        const std::int64_t x = (region.x + i) * step;
        xs_.insert(xs_.end(), {x - 1, x, x + 1});
      }
      around_.reshape(3 * region.width, 3);
      slopes_.resize(xs_.size() - 2);
    }
  }
  if (region.lod.value() == 0 || !knows_slopes_) rows_->start(xs_);
  if (places_) places_->start(asked.width, asked.depth);
}

void Ground::compute_rows(int count) {
  const int last = std::min(region_.depth, next_ + count);
  if (region_.lod.value() == 0) {
    compute_base(next_, last);
  } else {
    compute_coarse(next_, last);
  }
  next_ = last;
  if (pending()) return;
  if (aprons_) raise_aprons();
  if (places_) places_->thin_late(slope(), aprons_ ? &cliff_ : nullptr);
}

// Row z has rows z to z + 2 of `around_` about it.
void Ground::compute_base(int first, int last) {
  for (int z = first == 0 ? 0 : first + 2; z < last + 2; ++z) {
    rows_->row(region_.z - 1 + z, around_.row(z).data());
    if (z == 0 || z == region_.depth + 1) continue;
    std::copy_n(around_.row(z).begin() + 1, region_.width, height_.row(z - 1).begin());
    set_places(z - 1, 1, 1);
  }
  for (int z = first; z < last; ++z) {
    kernels_.slope(around_.row(z).data(), around_.row(z + 1).data(), around_.row(z + 2).data(),
                   static_cast<std::size_t>(region_.width), slope_.row(z).data());
  }
}

void Ground::compute_coarse(int first, int last) {
  const std::int64_t step = std::int64_t{1} << region_.lod.value();
  for (int z = first; knows_slopes_ && z < last; ++z) {
    rows_->sloped_row((region_.z + z) * step, height_.row(z).data(), slope_.row(z).data());
    set_places(z, 0, 1);
  }
  for (int z = first; !knows_slopes_ && z < last; ++z) {
    // The middle row last, as places ask for what it was made of.
    for (const int row : {0, 2, 1}) rows_->row((region_.z + z) * step + row - 1, around_.row(row).data());
    kernels_.slope(around_.row(0).data(), around_.row(1).data(), around_.row(2).data(), slopes_.size(),
                   slopes_.data());
    for (int x = 0; x < region_.width; ++x) {
      height_.at(x, z) = around_.at(3 * x + 1, 1);
      slope_.at(x, z) = slopes_[static_cast<std::size_t>(3 * x)];
    }
    set_places(z, 1, 3);
  }
}

// Row z of the region, which is the last that `rows_` has computed.
void Ground::set_places(int z, std::size_t first, std::size_t step) {
  const int asked_z = z - margin_;
  if (!places_ || asked_z < 0 || asked_z >= asked_.depth) return;
  rows_->quantities((region_.z + z) * (std::int64_t{1} << region_.lod.value()), quantities_);
  places_->set_row(
      asked_z, quantities_, first + static_cast<std::size_t>(margin_) * step, step,
      height_.row(z).subspan(static_cast<std::size_t>(margin_), static_cast<std::size_t>(asked_.width)));
}

void Ground::raise_aprons() {
  aprons_->compute(height_, slope_, margin_ - 1, at_level(apron_numbers_, region_.lod), with_ring_,
                   ringed_cliff_);
  height_.crop_into(margin_, bare_);
  with_ring_.crop_into(1, raised_);
  ringed_cliff_.crop_into(1, cliff_);
  raised_slope_.reshape(asked_.width, asked_.depth);
  if (region_.lod.value() == 0) {
    for (int z = 0; z < asked_.depth; ++z) {
      kernels_.slope(with_ring_.row(z).data(), with_ring_.row(z + 1).data(), with_ring_.row(z + 2).data(),
                     static_cast<std::size_t>(asked_.width), raised_slope_.row(z).data());
    }
    return;
  }
  // Base columns beside a coarse one have no apron of their own: it lies at its angle of repose.
  slope_.crop_into(margin_, raised_slope_);
  for (std::size_t i = 0; i < raised_slope_.values.size(); ++i) {
    if (raised_.values[i] > bare_.values[i]) raised_slope_.values[i] = apron_numbers_.c_fx;
  }
}

}  // namespace talus::terrain
