// Stratified rock: the sequence of layers and how thick each is where (thesis 3.4).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <tl/expected.hpp>

#include <talus/terrain/fbm.h>
#include <talus/terrain/field.h>
#include <talus/terrain/world.h>

namespace talus::terrain {

inline constexpr std::size_t kMaxLayers = 256;

/// The materials of the layers from the bottom up, as indices into `stratified`: the one with the largest
/// depth first, then each time the one whose depth is closest to the current depth (the first of the spec
/// on a tie), which falls by the thickness of what was laid. Ends with the layer at which the thicknesses
/// sum to at least 1.25 amplitude_q16; empty if that takes more than kMaxLayers.
[[nodiscard]] std::vector<std::size_t> layer_sequence(std::span<const StratifiedSpec> stratified,
                                                      std::int64_t amplitude_q16);

/// The noise that varies layer j of a world, j counted before any merging.
[[nodiscard]] Fbm layer_noise(const WorldSpec& spec, double roughness, std::size_t j);

/// Planes of one kind of rock: tops[p] is where materials[p] ends.
struct Strata {
  std::vector<MaterialId> materials;  // bottom up, no two neighbours equal
  std::vector<Field> tops;
};

/// The strata under `surface_fx` (LOD 0 heights at all (x, z) of the two lists of base columns, as
/// sample_fbm orders them): layers stack up from y = 0, what passes the surface is cut, the last plane is
/// the surface. Tops are shifted right by `shift` once they are exact. Needs no other column: no halo.
[[nodiscard]] Strata lay_strata(const World& world, std::span<const std::int64_t> xs,
                                std::span<const std::int64_t> zs, const Field& surface_fx, int shift);

}  // namespace talus::terrain
