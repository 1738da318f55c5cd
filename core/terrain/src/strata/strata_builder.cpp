#include "strata/strata_builder.h"

#include <algorithm>
#include <utility>

#include <talus/terrain/strata.h>
#include <talus/vectors/tables.h>

#include "noise/lattice_place.h"

namespace talus::terrain {
namespace {

// What is stacked on this many rows at once stays in the nearest cache, layer by layer.
constexpr std::size_t kBandDepth = 16;
// Layers of regions are slow: their noise is drawn at every so many rows, where its shortest wave is eight
// times as long.
constexpr std::int64_t kRowStep = 16;
constexpr std::int64_t kShortestBetweenRows = 8 * kRowStep;

LayerShape shape_of(const World& world, const StratumSpec& layer) {
  // No layer reaches past the highest surface over the deepest sunk strata, so a thicker one may stop there
  // without a difference.
  const std::int64_t lift_fx = (world.max_lift_q16() * world.spec().resolution + 255) >> 8;
  // Rounded up twice, that is 2^23 + 1 at most, which becomes an integer as 2^23 does.
  return {static_cast<float>(static_cast<double>(layer.thickness_q16) * world.spec().resolution * kSubvoxels /
                             65536.0),
          static_cast<float>(2.0 * layer.roughness), static_cast<float>(world.highest_fx() + lift_fx)};
}

}  // namespace

StrataBuilder::StrataBuilder(const World& world, InstructionSet set)
    : world_{world}, noise_{set}, kernels_{strata_kernels(set)} {
  for (const auto& feature : world.features()) {
    if (auto deformation = feature->make_deformation(set)) deformations_.push_back(std::move(deformation));
  }
  const auto& strata = world.strata();
  std::size_t plane = 0;
  for (std::size_t i = 0; i < strata.size(); ++i) {
    if (i > 0 && strata[i].material != strata[i - 1].material) ++plane;
    const Fbm noise = layer_noise(world.spec(), strata[i].roughness, i);
    const bool slow =
        world.spec().surface.regions && noise.period >> (noise.octaves - 1) >= kShortestBetweenRows;
    layers_.push_back({plane, noise, shape_of(world, strata[i]), slow});
  }
}

void StrataBuilder::start(std::span<const std::int64_t> xs, std::span<const std::int64_t> zs,
                          const Field& limit_fx, Extent extent, Planes& planes) {
  pending_ = true;
  xs_ = xs;
  zs_ = zs;
  extent_ = extent;
  planes_ = &planes;
  deformation_ = 0;
  if (deformations_.empty()) return start_layers(limit_fx);
  limit_fx_ = &limit_fx;
  lift_.reshape(limit_fx.width, limit_fx.depth);
  std::fill(lift_.values.begin(), lift_.values.end(), 0);
}

void StrataBuilder::step() {
  if (deformation_ < deformations_.size()) {
    deformations_[deformation_++]->add(xs_, zs_, lift_);
    if (deformation_ < deformations_.size()) return;
    reach_.reshape(limit_fx_->width, limit_fx_->depth);
    for (std::size_t i = 0; i < reach_.values.size(); ++i) {
      reach_.values[i] = limit_fx_->values[i] - lift_.values[i];
    }
    return start_layers(reach_);
  }
  if (band_ < zs_.size()) return step_band();
  if (filled_ < planes_->count()) return fill_plane(filled_++);
  pending_ = false;
  if (!deformations_.empty()) lift();
}

void StrataBuilder::lift() {
  for (Field& top : planes_->tops()) {
    for (std::size_t i = 0; i < top.values.size(); ++i) {
      top.values[i] = std::max(top.values[i] + lift_.values[i], 0);
    }
  }
}

void StrataBuilder::find_lines() {
  lines_.clear();
  rows_.clear();
  for (const std::int64_t z : zs_) {
    const std::int64_t north = floor_div(z, kRowStep) * kRowStep;
    if (lines_.empty() || lines_.back() < north) lines_.push_back(north);
    const std::size_t at = lines_.size() - (lines_.back() == north ? 1 : 2);
    rows_.push_back({at, static_cast<float>(z - north) / static_cast<float>(kRowStep)});
    if (z > north && lines_.back() == north) lines_.push_back(north + kRowStep);
  }
}

void StrataBuilder::start_layers(const Field& limit_fx) {
  limit_fx_ = &limit_fx;
  const std::size_t segments = (xs_.size() + kSegment - 1) / kSegment;
  open_rows_.assign(zs_.size(), 1);
  open_segments_.assign(zs_.size() * segments, 1);
  level_.assign(xs_.size(), 0);
  under_.resize(xs_.size());
  find_lines();
  // In bands all layers' noise is kept, so there must be little of it.
  bool in_bands = 4 * lines_.size() <= zs_.size() + 2 * 4;
  for (const Layer& layer : layers_) in_bands = in_bands && layer.slow;
  band_depth_ = in_bands ? kBandDepth : zs_.size();
  keeps_lines_ = in_bands;
  kept_.resize(in_bands ? layers_.size() : 1);
  for (LinesOfLayer& lines : kept_) lines.drawn = false;
  planes_of_bands_.clear();
  filled_ = 0;
  start_band(0);
}

void StrataBuilder::start_band(std::size_t first) {
  band_ = first;
  band_end_ = std::min(zs_.size(), first + band_depth_);
  layer_ = 0;
  full_ = false;
}

void StrataBuilder::step_band() {
  do {
    add_layer();
    ++layer_;
    if (layer_ < layers_.size() && !(full_ && extent_ == Extent::until_full)) continue;
    planes_of_bands_.push_back(layers_[layer_ - 1].plane + 1);
    return start_band(band_end_);
  } while (keeps_lines_);
}

/// To the rows of the band.
void StrataBuilder::add_layer() {
  Planes& planes = *planes_;
  const std::size_t width = xs_.size();
  const Layer& layer = layers_[layer_];
  const std::size_t plane = layer.plane;
  if (plane == planes.count()) {
    planes.add(world_.strata()[layer_].material).reshape(limit_fx_->width, limit_fx_->depth);
  }
  const std::int32_t* const limit = limit_fx_->values.data();
  std::int32_t* const top = planes.tops()[plane].values.data();
  if (full_ || layer_ + 1 == layers_.size()) {
    std::copy(limit + band_ * width, limit + band_end_ * width, top + band_ * width);
    full_ = true;
    return;
  }
  LinesOfLayer* lines = nullptr;
  if (!layer.slow) {
    noise_.start(layer.noise, xs_);
  } else {
    lines = &kept_[keeps_lines_ ? layer_ : 0];
    if (!keeps_lines_ || !lines->drawn) draw_lines(*lines);
  }
  full_ = true;
  for (std::size_t z = band_; z < band_end_; ++z) {
    if (open_rows_[z] == 0) {
      std::copy_n(limit + z * width, width, top + z * width);
      continue;
    }
    const bool open = stack_row(z, lines);
    open_rows_[z] = open ? 1 : 0;
    full_ = full_ && !open;
  }
}

void StrataBuilder::draw_lines(LinesOfLayer& lines) {
  const std::size_t row = padded(xs_.size());
  noise_.start(layers_[layer_].noise, xs_);
  lines.noise.resize(lines_.size() * row);
  lines.drawn = true;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    std::copy_n(noise_.row(lines_[i]), xs_.size(), lines.noise.data() + i * row);
  }
}

bool StrataBuilder::stack_row(std::size_t z, const LinesOfLayer* lines) {
  const std::size_t width = xs_.size();
  const std::size_t row = z * width;
  const Layer& layer = layers_[layer_];
  const std::size_t plane = layer.plane;
  std::int32_t* const top = planes_->tops()[plane].values.data() + row;
  const std::int32_t* under = level_.data();
  if (layer_ > 0 && layers_[layer_ - 1].plane == plane) {
    std::copy_n(top, width, under_.data());
    under = under_.data();
  } else if (plane > 0) {
    under = planes_->tops()[plane - 1].values.data() + row;
  }
  const std::int32_t* const limit = limit_fx_->values.data() + row;
  std::uint8_t* const open = open_segments_.data() + z * ((width + kSegment - 1) / kSegment);
  if (lines == nullptr) {
    const auto octaves = noise_.octaves(zs_[z]);
    return kernels_.stack(octaves.data(), octaves.size(), layer.shape, width, limit, under, open, top);
  }
  const BetweenLines& at = rows_[z];
  const std::size_t line = padded(width);
  const float* const north = lines->noise.data() + at.north * line;
  const float* const south = at.share == 0 ? north : north + line;
  return kernels_.stack_between(north, south, at.share, layer.shape, width, limit, under, open, top);
}

/// Where a band was full before it came to this plane.
void StrataBuilder::fill_plane(std::size_t plane) {
  const std::size_t width = xs_.size();
  for (std::size_t band = 0; band < planes_of_bands_.size(); ++band) {
    if (planes_of_bands_[band] > plane) continue;
    const std::size_t first = band * band_depth_ * width;
    const std::size_t last = std::min(zs_.size(), (band + 1) * band_depth_) * width;
    std::copy(limit_fx_->values.data() + first, limit_fx_->values.data() + last,
              planes_->tops()[plane].values.data() + first);
  }
}

}  // namespace talus::terrain
