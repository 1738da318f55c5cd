// What benchmarks work on: the same for the clock and for the instruction counter.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <talus/terrain/stacks.h>
#include <talus/voxel/chunk.h>

/// Calls `work`. Named for the instruction counter's --toggle-collect: not mangled, and in a file of its own
/// callers' sight so that no caller takes it in.
extern "C" void talus_counted_work(const std::function<void()>& work);

namespace talus::bench {

/// `count` neighbouring columns from `first` on.
[[nodiscard]] std::vector<std::int64_t> line(std::int64_t first, int count);

/// The mixed chunks over 8 x 8 tiles of a world, spread over four places far apart.
[[nodiscard]] std::vector<Chunk> mixed_chunks(const terrain::World& world = terrain::default_world(),
                                              Lod lod = {});

/// A sample world: "canyon", "hills".
[[nodiscard]] terrain::World sample_world(const std::string& name);

/// The same without its [caves].
[[nodiscard]] terrain::World without_caves(const std::string& name);

/// The chunks over 8 x 8 tiles of the features world that its caves change; or what they would be without.
[[nodiscard]] std::vector<Chunk> cave_chunks(bool with_caves);

/// The chunk with a winding tunnel through everything but air: still layers, with air between them.
[[nodiscard]] Chunk with_hole(const Chunk& chunk);

/// The chunk after somebody dug a pit and built a small house: dense voxels.
[[nodiscard]] Chunk edited(const Chunk& chunk);

/// Voxels of `materials` materials in runs of `run` on average.
[[nodiscard]] Chunk random_chunk(std::uint32_t seed, unsigned materials, unsigned run);

/// The patches that a view of `radius` chunks around the origin needs, nearest first.
[[nodiscard]] std::vector<terrain::Region> patches_of_view(int radius, int patch_tiles);

}  // namespace talus::bench
