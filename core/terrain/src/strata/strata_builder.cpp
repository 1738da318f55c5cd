#include "strata/strata_builder.h"

#include <algorithm>
#include <utility>

#include <talus/terrain/strata.h>

#include "noise/lattice_place.h"

namespace talus::terrain {
namespace {

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
  add_layer();
  ++layer_;
  pending_ = layer_ < world_.strata().size() && !(full_ && extent_ == Extent::until_full);
  if (!pending_ && !deformations_.empty()) lift();
}

void StrataBuilder::lift() {
  for (Field& top : planes_->tops()) {
    for (std::size_t i = 0; i < top.values.size(); ++i) {
      top.values[i] = std::max(top.values[i] + lift_.values[i], 0);
    }
  }
}

void StrataBuilder::start_layers(const Field& limit_fx) {
  limit_fx_ = &limit_fx;
  layer_ = 0;
  full_ = false;
  ground_.values.assign(limit_fx.values.size(), 0);
  const std::size_t segments = (xs_.size() + kSegment - 1) / kSegment;
  open_rows_.assign(zs_.size(), 1);
  open_segments_.assign(zs_.size() * segments, 1);
}

void StrataBuilder::add_layer() {
  const Field& limit_fx = *limit_fx_;
  Planes& planes = *planes_;
  const std::size_t width = xs_.size();
  const StratumSpec& layer = world_.strata()[layer_];
  const bool joins = !planes.empty() && planes.top_material() == layer.material;
  if (joins) std::swap(ground_, planes.top());
  Field& top = joins ? planes.top() : planes.add(layer.material);
  top.reshape(limit_fx.width, limit_fx.depth);
  const bool fills = layer_ + 1 == world_.strata().size();
  if (full_ || fills) {
    std::copy(limit_fx.values.begin(), limit_fx.values.end(), top.values.begin());
    full_ = true;
    return;
  }
  // A layer lies on the plane below its own, or on the earlier state of its own.
  const Field& below = joins || planes.count() == 1 ? ground_ : planes.below_top();
  const Fbm noise = layer_noise(world_.spec(), layer.roughness, layer_);
  noise_.start(noise, xs_);
  between_rows_ =
      world_.spec().surface.regions && noise.period >> (noise.octaves - 1) >= kShortestBetweenRows;
  for (SampledRow& row : sampled_rows_) row.drawn = false;
  const LayerShape shape = shape_of(world_, layer);
  full_ = true;
  for (std::size_t z = 0; z < zs_.size(); ++z) {
    const std::size_t row = z * width;
    if (open_rows_[z] == 0) {
      std::copy_n(limit_fx.values.data() + row, width, top.values.data() + row);
      continue;
    }
    const bool open = stack_row(z, shape, below, top);
    open_rows_[z] = open ? 1 : 0;
    full_ = full_ && !open;
  }
}

bool StrataBuilder::stack_row(std::size_t z, const LayerShape& shape, const Field& below, Field& top) {
  const std::size_t width = xs_.size();
  const std::size_t row = z * width;
  const std::int32_t* const limit = limit_fx_->values.data() + row;
  const std::int32_t* const under = below.values.data() + row;
  std::uint8_t* const open = open_segments_.data() + z * ((width + kSegment - 1) / kSegment);
  std::int32_t* const out = top.values.data() + row;
  const std::int64_t base_z = zs_[z];
  const std::int64_t north = floor_div(base_z, kRowStep) * kRowStep;
  if (!between_rows_ || base_z == north) {
    const auto octaves = noise_.octaves(base_z);
    return kernels_.stack(octaves.data(), octaves.size(), shape, width, limit, under, open, out);
  }
  const float share = static_cast<float>(base_z - north) / static_cast<float>(kRowStep);
  return kernels_.stack_between(sampled_row(north), sampled_row(north + kRowStep), share, shape, width, limit,
                                under, open, out);
}

/// Of the layer's noise; valid until two others have been asked for.
const float* StrataBuilder::sampled_row(std::int64_t z) {
  SampledRow& row = sampled_rows_[static_cast<std::size_t>(floor_mod(z / kRowStep, 2))];
  if (!row.drawn || row.z != z) {
    const float* const noise = noise_.row(z);
    row.noise.assign(noise, noise + xs_.size());
    row.z = z;
    row.drawn = true;
  }
  return row.noise.data();
}

}  // namespace talus::terrain
