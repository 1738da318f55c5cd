// Stratified rock: the sequence of layers and what varies each of them (thesis 3.4).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <talus/terrain/fbm.h>
#include <talus/terrain/world.h>

namespace talus::terrain {

inline constexpr std::size_t kMaxLayers = 256;

/// The materials of the layers from the bottom up, as indices into `stratified`: the one with the largest
/// depth first, then each time the one whose depth is closest to the current depth (the first of the spec
/// on a tie), which falls by the thickness of that layer. Ends with the layer at which the thicknesses
/// sum to at least 1.25 amplitude_q16 and `max_lift_q16`, by which strata may be sunk; empty if that takes
/// more than kMaxLayers.
[[nodiscard]] std::vector<std::size_t> layer_sequence(std::span<const StratifiedSpec> stratified,
                                                      std::int64_t amplitude_q16,
                                                      std::int64_t max_lift_q16 = 0);

/// The same of strata that repeat: all in their order, and then again and again from the first that is a band
/// on. REQUIRES that one is.
[[nodiscard]] std::vector<std::size_t> repeated_sequence(std::span<const StratifiedSpec> stratified,
                                                         std::int64_t amplitude_q16,
                                                         std::int64_t max_lift_q16 = 0);

/// The noise that varies layer j of a world, j counted before any merging.
[[nodiscard]] Fbm layer_noise(const WorldSpec& spec, double roughness, std::size_t j);

}  // namespace talus::terrain
