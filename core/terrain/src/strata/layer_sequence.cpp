#include <talus/terrain/strata.h>

#include <algorithm>
#include <cmath>

#include <talus/terrain/lattice_hash.h>

namespace talus::terrain {
std::vector<std::size_t> layer_sequence(std::span<const StratifiedSpec> stratified,
                                        std::int64_t amplitude_q16, std::int64_t max_lift_q16) {
  std::int64_t depth = stratified.front().depth_q16;
  for (const StratifiedSpec& material : stratified) depth = std::max(depth, material.depth_q16);
  std::vector<std::size_t> sequence;
  std::int64_t stacked = 0;
  while (4 * (stacked - max_lift_q16) < 5 * amplitude_q16) {
    if (sequence.size() == kMaxLayers) return {};
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < stratified.size(); ++i) {
      const auto distance = [&](std::size_t m) { return std::abs(stratified[m].depth_q16 - depth); };
      if (distance(i) < distance(nearest)) nearest = i;
    }
    sequence.push_back(nearest);
    depth -= stratified[nearest].thickness_q16;
    stacked += stratified[nearest].thickness_q16;
  }
  return sequence;
}

std::vector<std::size_t> repeated_sequence(std::span<const StratifiedSpec> stratified,
                                           std::int64_t amplitude_q16, std::int64_t max_lift_q16) {
  const auto bands = std::find_if(stratified.begin(), stratified.end(),
                                  [](const StratifiedSpec& material) { return material.band; });
  const auto first_band = static_cast<std::size_t>(bands - stratified.begin());
  std::vector<std::size_t> sequence;
  std::int64_t stacked = 0;
  for (std::size_t next = 0; 4 * (stacked - max_lift_q16) < 5 * amplitude_q16; ++next) {
    if (sequence.size() == kMaxLayers) return {};
    if (next == stratified.size()) next = first_band;
    sequence.push_back(next);
    stacked += stratified[next].thickness_q16;
  }
  return sequence;
}

Fbm layer_noise(const WorldSpec& spec, double roughness, std::size_t j) {
  const double period = spec.resolution * spec.strata_wavelength / (1.0 + 3.0 * roughness);
  Fbm noise;
  noise.seed = derived_seed(spec.seed, 0x5354524154410000U + j);  // apart from the surface's octaves
  noise.period = std::max<std::int64_t>(8, static_cast<std::int64_t>(std::floor(period + 0.5)));
  noise.octaves = spec.strata_octaves;
  return noise;
}

}  // namespace talus::terrain
