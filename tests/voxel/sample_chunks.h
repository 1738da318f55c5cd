// Chunks of every kind that the codec meets, made from a seed: the same chunk from the same seed everywhere.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <talus/voxel/chunk.h>

namespace talus::testing {

/// Planes of random rows, unordered materials, needless planes among them. `smoothness` 0 is noise; the
/// higher, the more rarely a row differs from its neighbour's.
[[nodiscard]] Layers random_layers(std::uint64_t seed, std::size_t planes, int smoothness);

/// Planes that often leap from any row to any other, 0 and 32 among them.
[[nodiscard]] Layers leaping_layers(std::uint64_t seed, std::size_t planes);

/// Strata, a loose layer that comes and goes, water and air: what the generator makes.
[[nodiscard]] Layers hill(std::uint64_t seed);

/// `materials` different ids in runs of `run` voxels on average along x.
[[nodiscard]] std::unique_ptr<DenseVoxels> random_voxels(std::uint64_t seed, std::size_t materials,
                                                         std::size_t run);

/// The chunk with up to 900 overrides of seven materials, in lumps.
[[nodiscard]] Chunk with_random_overrides(const Chunk& chunk, std::uint64_t seed);

[[nodiscard]] std::unique_ptr<DenseVoxels> voxels_of(const Chunk& chunk);

[[nodiscard]] std::vector<std::byte> encoded(const Chunk& chunk);

/// tests/voxel/golden/vVERSION/NAME.bin.
/// The same with ids that take three bytes each as numbers.
[[nodiscard]] Layers with_large_ids(Layers layers);

[[nodiscard]] std::vector<std::byte> frozen(int version, const std::string& name);

/// A chunk of any kind, chosen by RapidCheck.
[[nodiscard]] Chunk any_chunk();

}  // namespace talus::testing
