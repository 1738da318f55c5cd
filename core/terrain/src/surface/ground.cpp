#include "surface/ground.h"

#include <algorithm>
#include <utility>

#include "noise/lattice_place.h"

namespace talus::terrain {

namespace {

// Coarser columns need few columns around them.
constexpr int kCoarsestCached = 1;

}  // namespace

Ground::Ground(const World& world, InstructionSet set, bool places, std::shared_ptr<GroundCache> cache)
    : kernels_{column_kernels(set)} {
  Surface surface = surface_of(world.spec());
  if (!places) surface.places.reset();
  rows_ = make_surface_rows(surface, set);
  // Other surfaces cost less than a lookup.
  if (rows_->knows_slopes()) cache_ = std::move(cache);
  if (world.spec().talus) {
    aprons_.emplace(set);
    apron_numbers_ = apron_numbers(world);
  }
  if (!surface.places) return;
  quantities_.resize(surface.places->quantities);
  const auto subvoxels_a_unit = static_cast<float>(world.spec().resolution * kSubvoxels);
  std::vector<bool> at_points(surface.places->shares.size(), true);
  for (const LooseSpec& loose : world.loose()) {
    if (loose.share) at_points[*loose.share] = false;
  }
  places_.emplace(surface.places, world.sea_fx().value_or(0), subvoxels_a_unit, set, std::move(at_points));
  if (cache_) places_of_block_.emplace(surface.places, world.sea_fx().value_or(0), subvoxels_a_unit, set);
}

bool Ground::caches(Lod lod) const {
  return cache_ && lod.value() <= kCoarsestCached;
}

void Ground::start(const Region& asked) {
  asked_ = asked;
  // One more column, so that the slope of raised ground is known.
  margin_ = aprons_ ? apron_halo(at_level(apron_numbers_, asked.lod)) + 1 : 0;
  region_ = asked.expanded(margin_);
  knows_slopes_ = coarse() && rows_->knows_slopes();
  tiled_ = caches(asked.lod);
  known_ = coarse() ? region_ : region_.expanded(1);
  if (tiled_) {
    const std::int64_t x = floor_div(known_.x, kGroundTileSide) * kGroundTileSide;
    const std::int64_t z = floor_div(known_.z, kGroundTileSide) * kGroundTileSide;
    const auto whole = [](std::int64_t columns) {
      return static_cast<int>((columns + kGroundTileSide - 1) / kGroundTileSide * kGroundTileSide);
    };
    known_ = {x, z, whole(known_.x + known_.width - x), whole(known_.z + known_.depth - z), asked.lod};
  }
  height_.reshape(region_.width, region_.depth);
  slope_.reshape(region_.width, region_.depth);
  known_height_.reshape(known_.width, known_.depth);
  if (knows_slopes_) known_slope_.reshape(known_.width, known_.depth);
  if (places_) places_->start(asked.width, asked.depth, tiled_);
  blocks_.clear();
  block_ = 0;
  next_ = 0;
  pending_ = true;
  if (tiled_) {
    look_up_tiles();
  } else {
    blocks_.push_back({0, 0, known_.width, known_.depth});
  }
}

GroundTileKey Ground::key_of(int tile_x, int tile_z) const {
  return {known_.x / kGroundTileSide + tile_x, known_.z / kGroundTileSide + tile_z, known_.lod.value()};
}

// Groups unknown tiles into blocks, as wide as possible and then as deep.
void Ground::look_up_tiles() {
  const int width = known_.width / kGroundTileSide;
  const int depth = known_.depth / kGroundTileSide;
  keys_.clear();
  for (int z = 0; z < depth; ++z) {
    for (int x = 0; x < width; ++x) keys_.push_back(key_of(x, z));
  }
  found_.resize(keys_.size());
  cache_->tiles().find(keys_, found_);
  for (int z = 0; z < depth; ++z) {
    for (int x = 0; x < width;) {
      const GroundTilePtr* const row = &found_[static_cast<std::size_t>(z) * static_cast<std::size_t>(width)];
      if (row[x]) {
        take_tile(x, z, row[x]);
        ++x;
        continue;
      }
      int end = x;
      while (end < width && !row[end]) ++end;
      const Block block{x * kGroundTileSide, z * kGroundTileSide, (end - x) * kGroundTileSide,
                        kGroundTileSide};
      const auto above = std::find_if(blocks_.begin(), blocks_.end(), [&](const Block& other) {
        return other.x == block.x && other.width == block.width && other.z + other.depth == block.z;
      });
      if (above != blocks_.end()) {
        above->depth += kGroundTileSide;
      } else {
        blocks_.push_back(block);
      }
      x = end;
    }
  }
  found_.assign(found_.size(), nullptr);
}

void Ground::take_tile(int tile_x, int tile_z, const GroundTilePtr& tile) {
  const int x = tile_x * kGroundTileSide;
  const int z = tile_z * kGroundTileSide;
  for (int row = 0; row < kGroundTileSide; ++row) {
    copy_tile_row(&tile->heights_fx[static_cast<std::size_t>(row * kGroundTileSide)], kGroundTileSide,
                  &known_height_.at(x, z + row));
    if (!knows_slopes_) continue;
    copy_tile_row(&tile->slopes_fx.front()[static_cast<std::size_t>(row * kGroundTileSide)], kGroundTileSide,
                  &known_slope_.at(x, z + row));
  }
  if (places_) {
    places_->take(x + static_cast<int>(known_.x - asked_.x), z + static_cast<int>(known_.z - asked_.z), tile);
  }
}

// Caches the tiles of a block that begin at its row `first`.
void Ground::keep_tiles(const Block& block, int first) {
  const int z = block.z + first;
  for (int x = block.x; x < block.x + block.width; x += kGroundTileSide) {
    auto tile = std::make_shared_for_overwrite<GroundTile>();
    if (knows_slopes_) tile->slopes_fx.resize(1);
    for (int row = 0; row < kGroundTileSide; ++row) {
      const auto to = static_cast<std::size_t>(row * kGroundTileSide);
      copy_tile_row(&known_height_.at(x, z + row), kGroundTileSide, &tile->heights_fx[to]);
      if (!knows_slopes_) continue;
      copy_tile_row(&known_slope_.at(x, z + row), kGroundTileSide, &tile->slopes_fx.front()[to]);
    }
    if (places_) places_of_block_->fill(x - block.x, 0, *tile);
    GroundTilePtr kept = std::move(tile);
    if (places_) {
      places_->take(x + static_cast<int>(known_.x - asked_.x), z + static_cast<int>(known_.z - asked_.z),
                    kept);
    }
    cache_->tiles().put(key_of(x / kGroundTileSide, z / kGroundTileSide), std::move(kept));
  }
}

void Ground::compute_rows(int count) {
  for (; count > 0 && block_ < blocks_.size(); --count) {
    const Block& block = blocks_[block_];
    if (next_ == 0) begin(block);
    if (coarse() && !knows_slopes_) {
      compute_row_by_neighbours(block, next_);
    } else {
      compute_row(block, next_);
    }
    ++next_;
    if (tiled_ && next_ % kGroundTileSide == 0) keep_tiles(block, next_ - kGroundTileSide);
    if (next_ < block.depth) continue;
    next_ = 0;
    ++block_;
  }
  if (block_ < blocks_.size()) return;
  finish();
  pending_ = false;
}

void Ground::begin(const Block& block) {
  const std::int64_t step = std::int64_t{1} << known_.lod.value();
  const std::int64_t first = known_.x + block.x;
  xs_.clear();
  if (coarse() && !knows_slopes_) {
    // Each coarse column uses the three base columns and rows around it.
    for (int i = 0; i < block.width; ++i) {
      const std::int64_t x = (first + i) * step;
      xs_.insert(xs_.end(), {x - 1, x, x + 1});
    }
    around_.reshape(3 * block.width, 3);
    slopes_.resize(xs_.size() - 2);
  } else {
    for (int i = 0; i < block.width; ++i) xs_.push_back((first + i) * step);
  }
  if (!knows_slopes_ || !rows_->starts_level(xs_, known_.lod)) rows_->start(xs_);
}

// z is a row of the block, also below.
void Ground::compute_row(const Block& block, int z) {
  const std::int64_t base_z = (known_.z + block.z + z) * (std::int64_t{1} << known_.lod.value());
  std::int32_t* const heights = &known_height_.at(block.x, block.z + z);
  if (knows_slopes_) {
    rows_->sloped_row(base_z, heights, &known_slope_.at(block.x, block.z + z));
  } else {
    rows_->row(base_z, heights);
  }
  set_places(block, z, 0, 1);
}

void Ground::compute_row_by_neighbours(const Block& block, int z) {
  const std::int64_t base_z = (known_.z + block.z + z) * (std::int64_t{1} << known_.lod.value());
  // The middle row last, because quantities() refers to the last row.
  for (const int row : {0, 2, 1}) rows_->row(base_z + row - 1, around_.row(row).data());
  kernels_.slope(around_.row(0).data(), around_.row(1).data(), around_.row(2).data(), slopes_.size(),
                 slopes_.data());
  for (int x = 0; x < block.width; ++x) {
    known_height_.at(block.x + x, block.z + z) = around_.at(3 * x + 1, 1);
    slope_.at(block.x + x, block.z + z) = slopes_[static_cast<std::size_t>(3 * x)];
  }
  set_places(block, z, 1, 3);
}

// Sets places for the last row of `rows_`: the whole row of a block of tiles, or the requested columns.
void Ground::set_places(const Block& block, int z, std::size_t first, std::size_t step) {
  if (!places_) return;
  const auto asked_x = static_cast<int>(asked_.x - known_.x);
  const int known_z = block.z + z;
  const int asked_z = known_z - static_cast<int>(asked_.z - known_.z);
  if (!tiled_ && (asked_z < 0 || asked_z >= asked_.depth)) return;
  rows_->quantities((known_.z + known_z) * (std::int64_t{1} << known_.lod.value()), quantities_);
  const auto heights = known_height_.row(known_z);
  if (tiled_) {
    if (z % kGroundTileSide == 0) places_of_block_->start(block.width, kGroundTileSide);
    places_of_block_->set_row(
        z % kGroundTileSide, quantities_, first, step,
        heights.subspan(static_cast<std::size_t>(block.x), static_cast<std::size_t>(block.width)));
  } else {
    places_->set_row(
        asked_z, quantities_, first + static_cast<std::size_t>(asked_x) * step, step,
        heights.subspan(static_cast<std::size_t>(asked_x), static_cast<std::size_t>(asked_.width)));
  }
}

void Ground::finish() {
  const auto x = static_cast<std::size_t>(region_.x - known_.x);
  const auto z = static_cast<int>(region_.z - known_.z);
  const auto width = static_cast<std::size_t>(region_.width);
  for (int row = 0; row < region_.depth; ++row) {
    std::copy_n(known_height_.row(z + row).data() + x, width, height_.row(row).begin());
    if (!coarse()) {
      kernels_.slope(known_height_.row(z + row - 1).data() + x - 1, known_height_.row(z + row).data() + x - 1,
                     known_height_.row(z + row + 1).data() + x - 1, width, slope_.row(row).data());
    } else if (knows_slopes_) {
      std::copy_n(known_slope_.row(z + row).data() + x, width, slope_.row(row).begin());
    }
  }
  if (aprons_) raise_aprons();
  if (places_) places_->thin_late(slope(), aprons_ ? &cliff_ : nullptr);
}

void Ground::raise_aprons() {
  aprons_->compute(height_, slope_, margin_ - 1, at_level(apron_numbers_, region_.lod), with_ring_, cliff_,
                   1);
  with_ring_.crop_into(1, raised_);
  raised_slope_.reshape(asked_.width, asked_.depth);
  if (region_.lod.value() == 0) {
    for (int z = 0; z < asked_.depth; ++z) {
      kernels_.slope(with_ring_.row(z).data(), with_ring_.row(z + 1).data(), with_ring_.row(z + 2).data(),
                     static_cast<std::size_t>(asked_.width), raised_slope_.row(z).data());
    }
    return;
  }
  // Base columns next to a coarse one have no apron of their own: an apron's slope is its angle of repose.
  slope_.crop_into(margin_, raised_slope_);
  for (int z = 0; z < asked_.depth; ++z) {
    const std::int32_t* const bare = height_.row(z + margin_).data() + margin_;
    const auto raised = raised_.row(z);
    const auto slope = raised_slope_.row(z);
    for (std::size_t x = 0; x < raised.size(); ++x) {
      if (raised[x] > bare[x]) slope[x] = apron_numbers_.c_fx;
    }
  }
}

}  // namespace talus::terrain
