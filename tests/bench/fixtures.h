// What benchmarks work on: the same for the clock and for the instruction counter.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <talus/terrain/stacks.h>
#include <talus/voxel/chunk.h>

/// Calls `work`. Named for the instruction counter's --toggle-collect: not mangled, and in a file of its own
/// callers' sight so that no caller takes it in.
extern "C" void talus_counted_work(const std::function<void()>& work);

namespace talus::bench {

/// `count` neighbouring columns from `first` on.
[[nodiscard]] std::vector<std::int64_t> line(std::int64_t first, int count);

/// The mixed chunks over 8 x 8 tiles of the default world, spread over four places far apart.
[[nodiscard]] std::vector<Chunk> mixed_chunks();

/// The patches that a view of `radius` chunks around the origin needs, nearest first.
[[nodiscard]] std::vector<terrain::Region> patches_of_view(int radius, int patch_tiles);

}  // namespace talus::bench
