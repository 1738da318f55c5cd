#include "strata/strata_builder.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include <talus/terrain/strata.h>
#include <talus/vectors/tables.h>

#include "noise/lattice_place.h"

namespace talus::terrain {
namespace {

// Rows stacked at once, layer by layer, so that they stay in the nearest cache.
constexpr std::size_t kBandDepth = 16;
// Layers stacked at once on a row, which is read and written once for all of them.
constexpr std::size_t kLayersAtOnce = 4;
// Maximum and minimum number of layers stacked at once if they surely end under the limit; fewer are as fast
// by the general way.
constexpr std::size_t kMaxStackedLayers = 16;
constexpr std::size_t kMinStackedLayers = 3;
// Layers of regions are slow if their shortest wave is at least eight times kRowStep: their noise is drawn
// only at every kRowStep-th row.
constexpr std::int64_t kRowStep = 16;
constexpr std::int64_t kShortestBetweenRows = 8 * kRowStep;

LayerShape shape_of(const World& world, const StratumSpec& layer) {
  // No layer reaches past the highest surface above the deepest sunk strata, so capping a thicker layer there
  // makes no difference.
  const std::int64_t lift_fx = (world.max_lift_q16() * world.spec().resolution + 255) >> 8;
  // Rounded up twice, so at most 2^23 + 1, which converts to the same integer as 2^23.
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
  if (filled_ == 0) drop_planes();
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
  // Bands keep all layers' noise, so it must be small.
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
  near_limit_ = false;
}

void StrataBuilder::step_band() {
  do {
    if (keeps_lines_ && !full_ && layer_ + 1 < layers_.size()) {
      if (near_limit_ || !add_inside()) add_layers();
    } else {
      add_layer();
      ++layer_;
    }
    if (layer_ < layers_.size() && !(full_ && extent_ == Extent::until_full)) continue;
    planes_of_bands_.push_back(layers_[layer_ - 1].plane + 1);
    return start_band(band_end_);
  } while (keeps_lines_);
}

/// Returns the plane of a layer; adds it if it is the next one.
std::int32_t* StrataBuilder::plane_of(std::size_t layer) {
  const std::size_t plane = layers_[layer].plane;
  if (plane == planes_->count()) {
    planes_->add(world_.strata()[layer].material).reshape(limit_fx_->width, limit_fx_->depth);
  }
  return planes_->tops()[plane].values.data();
}

/// Adds `layer_` to the rows of the band.
void StrataBuilder::add_layer() {
  const std::size_t width = xs_.size();
  const Layer& layer = layers_[layer_];
  const std::int32_t* const limit = limit_fx_->values.data();
  std::int32_t* const top = plane_of(layer_);
  if (full_ || layer_ + 1 == layers_.size()) {
    std::copy(limit + band_ * width, limit + band_end_ * width, top + band_ * width);
    full_ = true;
    return;
  }
  LinesOfLayer* const lines = layer.slow ? &kept_.front() : nullptr;
  if (lines == nullptr) {
    noise_.start(layer.noise, xs_);
  } else {
    draw_lines(layer_, *lines);
  }
  const LinedLayer lined = lines != nullptr ? lined_layer(layer_, *lines, top) : LinedLayer{};
  full_ = true;
  for (std::size_t z = band_; z < band_end_; ++z) {
    if (open_rows_[z] == 0) {
      std::copy_n(limit + z * width, width, top + z * width);
      continue;
    }
    const bool open = lines != nullptr ? stack_between(z, {&lined, 1}) > 1 : stack_row(z, top);
    open_rows_[z] = open ? 1 : 0;
    full_ = full_ && !open;
  }
}

/// Adds slow layers to the rows of the band, from `layer_` on, as many as surely end under the limit in all
/// columns. Returns false if they are too few: the rest of the band is then built layer by layer, including
/// layers that would end under the limit again.
bool StrataBuilder::add_inside() {
  if (layer_ == 0) room_fx_ = stack_inside({});
  std::size_t count = 0;
  for (std::int32_t room_fx = room_fx_; count < std::min(kMaxStackedLayers, layers_.size() - 1 - layer_);
       ++count) {
    const LayerShape& shape = layers_[layer_ + count].shape;
    if (!shape.is_bounded() || shape.bound_fx() >= room_fx) break;
    room_fx -= shape.bound_fx();
  }
  near_limit_ = count < kMinStackedLayers;
  if (near_limit_) return false;
  std::array<LinedLayer, kMaxStackedLayers> layers;
  room_fx_ = stack_inside(lined_layers(layers.data(), count));
  layer_ += count;
  return true;
}

std::int32_t StrataBuilder::stack_inside(std::span<const LinedLayer> layers) {
  const std::size_t width = xs_.size();
  std::int32_t room_fx = std::numeric_limits<std::int32_t>::max();
  for (std::size_t z = band_; z < band_end_; ++z) {
    room_fx = std::min(room_fx, kernels_.stack_inside(layers.data(), layers.size(), row_between(z), width,
                                                      limit_fx_->values.data() + z * width, under(z)));
  }
  return room_fx;
}

/// Returns the next `count` layers, in `memory`.
std::span<const LinedLayer> StrataBuilder::lined_layers(LinedLayer* memory, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    LinesOfLayer& lines = kept_[layer_ + i];
    if (!lines.drawn) draw_lines(layer_ + i, lines);
    memory[i] = lined_layer(layer_ + i, lines, plane_of(layer_ + i));
  }
  return {memory, count};
}

/// Adds slow layers to the rows of the band, from `layer_` on: kLayersAtOnce, or as many as fill the band.
void StrataBuilder::add_layers() {
  const std::size_t width = xs_.size();
  const std::int32_t* const limit = limit_fx_->values.data();
  const std::size_t count = std::min(kLayersAtOnce, layers_.size() - 1 - layer_);
  std::array<LinedLayer, kLayersAtOnce> memory;
  const std::span<const LinedLayer> layers = lined_layers(memory.data(), count);
  std::size_t taken = 1;
  for (std::size_t z = band_; z < band_end_; ++z) {
    if (open_rows_[z] == 0) {
      for (const LinedLayer& layer : layers) std::copy_n(limit + z * width, width, layer.top + z * width);
      continue;
    }
    const std::size_t of_row = stack_between(z, layers);
    open_rows_[z] = of_row > count ? 1 : 0;
    taken = std::max(taken, of_row);
  }
  full_ = taken <= count;
  layer_ += std::min(taken, count);
}

void StrataBuilder::draw_lines(std::size_t layer, LinesOfLayer& lines) {
  const std::size_t row = padded(xs_.size());
  noise_.start(layers_[layer].noise, xs_);
  lines.noise.resize(lines_.size() * row);
  lines.rise.resize(lines_.size() * row);
  lines.drawn = true;
  for (std::size_t i = 0; i < lines_.size(); ++i) noise_.row_into(lines_[i], lines.noise.data() + i * row);
  kernels_.find_rises(lines.noise.data(), row, lines_.size(), lines.rise.data());
}

LinedLayer StrataBuilder::lined_layer(std::size_t layer, const LinesOfLayer& lines, std::int32_t* top) const {
  return {layers_[layer].shape, lines.noise.data(), lines.rise.data(), top};
}

/// The row z on which `layer_` lies.
const std::int32_t* StrataBuilder::under(std::size_t z) {
  const std::size_t plane = layers_[layer_].plane;
  const std::size_t row = z * xs_.size();
  if (layer_ > 0 && layers_[layer_ - 1].plane == plane) {
    std::copy_n(planes_->tops()[plane].values.data() + row, xs_.size(), under_.data());
    return under_.data();
  }
  return plane > 0 ? planes_->tops()[plane - 1].values.data() + row : level_.data();
}

std::uint8_t* StrataBuilder::open_of(std::size_t z) {
  return open_segments_.data() + z * ((xs_.size() + kSegment - 1) / kSegment);
}

bool StrataBuilder::stack_row(std::size_t z, std::int32_t* top) {
  const std::size_t width = xs_.size();
  const auto octaves = noise_.octaves(zs_[z]);
  return kernels_.stack(octaves.data(), octaves.size(), layers_[layer_].shape, width,
                        limit_fx_->values.data() + z * width, under(z), open_of(z), top + z * width);
}

std::size_t StrataBuilder::stack_between(std::size_t z, std::span<const LinedLayer> layers) {
  const std::size_t width = xs_.size();
  return kernels_.stack_between(layers.data(), layers.size(), row_between(z), width,
                                limit_fx_->values.data() + z * width, under(z), open_of(z));
}

RowBetween StrataBuilder::row_between(std::size_t z) const {
  const std::size_t width = xs_.size();
  return {rows_[z].north * padded(width), rows_[z].share, z * width};
}

/// Drops the planes that no band has filled: several layers are stacked at once.
void StrataBuilder::drop_planes() {
  const auto most = std::max_element(planes_of_bands_.begin(), planes_of_bands_.end());
  planes_->keep(most == planes_of_bands_.end() ? 0 : *most);
}

/// Completes the plane in bands that were full before they came to it.
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
