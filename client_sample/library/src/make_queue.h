// Chunks of a View that are to be made here, nearest first, in batches that share their columns. Pure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

#include <talus/client/view.h>
#include <talus/voxel/view_order.h>

namespace talus::client {

class MakeQueue {
 public:
  /// Columns along an edge of the aligned squares whose chunks are made together, as generating one column
  /// takes as much work as some of its neighbours.
  static constexpr std::int32_t kPatchColumns = 4;
  /// A batch takes along chunks of the patch at most this much farther away than its nearest, in chunks.
  static constexpr std::uint64_t kFarther = 4;
  static constexpr std::size_t kMaxBatch = 512;

  MakeQueue() = default;
  MakeQueue(const View& view, const std::vector<ChunkKey>& chunks);

  /// Takes the nearest chunk and those made together with it, nearest first; empty after the last.
  [[nodiscard]] std::vector<ChunkKey> next();
  [[nodiscard]] bool empty() const { return order_.empty(); }

 private:
  struct Ranked {
    std::uint64_t rank = 0;
    ChunkKey key;
    auto operator<=>(const Ranked&) const = default;
  };
  using PatchName = std::tuple<Lod, std::int32_t, std::int32_t>;
  using Patch = std::vector<Ranked>;                   // the nearest last
  using Next = std::pair<std::uint64_t, std::size_t>;  // rank of its nearest, index of the patch

  std::vector<Patch> patches_;
  std::priority_queue<Next, std::vector<Next>, std::greater<>> order_;
};

}  // namespace talus::client
