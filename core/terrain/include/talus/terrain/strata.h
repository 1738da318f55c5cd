// Stratified rock: the sequence of layers and the noise of each (thesis 3.4).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <talus/terrain/fbm.h>
#include <talus/terrain/world.h>

namespace talus::terrain {

inline constexpr std::size_t kMaxLayers = 256;

/// Returns the materials of the layers from the bottom up, as indices into `stratified`. The first is the one
/// with the largest depth. Each next one is the one whose depth is closest to the current depth (on a tie the
/// first of the spec); the current depth falls by each layer's thickness. Ends with the layer at which the
/// thicknesses sum to at least 1.25 amplitude_q16 plus `max_lift_q16`, by which strata may be sunk. Empty if
/// that takes more than kMaxLayers.
[[nodiscard]] std::vector<std::size_t> layer_sequence(std::span<const StratifiedSpec> stratified,
                                                      std::int64_t amplitude_q16,
                                                      std::int64_t max_lift_q16 = 0);

/// The sequence of strata that repeat: all in order, then repeatedly from the first band on. REQUIRES that at
/// least one is a band.
[[nodiscard]] std::vector<std::size_t> repeated_sequence(std::span<const StratifiedSpec> stratified,
                                                         std::int64_t amplitude_q16,
                                                         std::int64_t max_lift_q16 = 0);

/// The noise of layer j of a world; j counts layers before merging.
[[nodiscard]] Fbm layer_noise(const WorldSpec& spec, double roughness, std::size_t j);

}  // namespace talus::terrain
