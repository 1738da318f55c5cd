#include <talus/terrain/strata.h>

#include <algorithm>
#include <cmath>

#include <talus/terrain/lattice_hash.h>
#include <talus/terrain/rounding.h>

namespace talus::terrain {
namespace {

constexpr int kLayerOctaves = 4;
// Layer noise is drawn block by block, so that ground which is already full pays for no more layers.
constexpr int kBlock = 32;

struct Block {
  int x;
  int z;
  int width;
  int depth;
};

// Lays the layers of one block into `planes`, which hold the cut tops, bottom up.
class BlockLayers {
 public:
  BlockLayers(const World& world, std::span<const std::int64_t> xs, std::span<const std::int64_t> zs,
              const Field& surface_fx, const Block& block)
      : world_{world},
        xs_{xs.subspan(static_cast<std::size_t>(block.x), static_cast<std::size_t>(block.width))},
        zs_{zs.subspan(static_cast<std::size_t>(block.z), static_cast<std::size_t>(block.depth))},
        surface_{surface_fx},
        block_{block},
        top_(xs_.size() * zs_.size(), 0),
        noise_(top_.size()) {}

  // The top of layer j over the block, given that all layers below it were laid before.
  void lay(std::size_t j, Field& plane) {
    const StratumSpec& layer = world_.strata()[j];
    const bool last = j + 1 == world_.strata().size();
    if (!full_ && !last) raise_by(layer, j);
    full_ = true;
    for (int z = 0; z < block_.depth; ++z) {
      const std::int32_t* surface = surface_.row(block_.z + z).data() + block_.x;
      std::int32_t* out = plane.row(block_.z + z).data() + block_.x;
      std::int32_t* top = top_.data() + static_cast<std::size_t>(z * block_.width);
      for (int x = 0; x < block_.width; ++x) {
        if (last || top[x] >= surface[x]) {
          top[x] = surface[x];
        } else {
          full_ = false;
        }
        out[x] = top[x];
      }
    }
  }

 private:
  void raise_by(const StratumSpec& layer, std::size_t j) {
    sample_fbm(layer_noise(world_.spec(), layer.roughness, j), xs_, zs_, noise_);
    const auto mean_fx = static_cast<float>(static_cast<double>(layer.thickness_q16) *
                                            world_.spec().resolution * kSubvoxels / 65536.0);
    const auto swing = static_cast<float>(2.0 * layer.roughness);
    // Nothing reaches past the highest surface, so a thicker layer may stop there without a difference.
    const auto most_fx = static_cast<float>(world_.highest_fx());
    for (std::size_t i = 0; i < top_.size(); ++i) {
      const float thickness = mean_fx * std::max(0.0F, 1.0F + swing * noise_[i]);
      top_[i] += round_to_even(std::min(thickness, most_fx));
    }
  }

  const World& world_;
  std::span<const std::int64_t> xs_;
  std::span<const std::int64_t> zs_;
  const Field& surface_;
  Block block_;
  std::vector<std::int32_t> top_;
  std::vector<float> noise_;
  bool full_ = false;
};

}  // namespace

std::vector<std::size_t> layer_sequence(std::span<const StratifiedSpec> stratified,
                                        std::int64_t amplitude_q16) {
  std::int64_t depth = stratified.front().depth_q16;
  for (const StratifiedSpec& material : stratified) depth = std::max(depth, material.depth_q16);
  std::vector<std::size_t> sequence;
  std::int64_t laid = 0;
  while (4 * laid < 5 * amplitude_q16) {
    if (sequence.size() == kMaxLayers) return {};
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < stratified.size(); ++i) {
      const auto distance = [&](std::size_t m) { return std::abs(stratified[m].depth_q16 - depth); };
      if (distance(i) < distance(nearest)) nearest = i;
    }
    sequence.push_back(nearest);
    depth -= stratified[nearest].thickness_q16;
    laid += stratified[nearest].thickness_q16;
  }
  return sequence;
}

Fbm layer_noise(const WorldSpec& spec, double roughness, std::size_t j) {
  const double period = spec.resolution * spec.strata_wavelength / (1.0 + 3.0 * roughness);
  Fbm noise;
  noise.seed = derived_seed(spec.seed, 0x5354524154410000U + j);  // apart from the surface's octaves
  noise.period = std::max<std::int64_t>(8, static_cast<std::int64_t>(std::floor(period + 0.5)));
  noise.octaves = kLayerOctaves;
  return noise;
}

Strata lay_strata(const World& world, std::span<const std::int64_t> xs, std::span<const std::int64_t> zs,
                  const Field& surface_fx, int shift) {
  std::vector<BlockLayers> blocks;
  for (int z = 0; z < surface_fx.depth; z += kBlock) {
    for (int x = 0; x < surface_fx.width; x += kBlock) {
      blocks.emplace_back(
          world, xs, zs, surface_fx,
          Block{x, z, std::min(kBlock, surface_fx.width - x), std::min(kBlock, surface_fx.depth - z)});
    }
  }
  Strata strata;
  for (std::size_t j = 0; j < world.strata().size(); ++j) {
    const MaterialId material = world.strata()[j].material;
    if (strata.materials.empty() || strata.materials.back() != material) {
      strata.materials.push_back(material);
      strata.tops.emplace_back(surface_fx.width, surface_fx.depth);
    }
    for (BlockLayers& block : blocks) block.lay(j, strata.tops.back());
  }
  if (shift > 0) {
    for (Field& plane : strata.tops) {
      for (std::int32_t& top : plane.values) top >>= shift;
    }
  }
  return strata;
}

}  // namespace talus::terrain
