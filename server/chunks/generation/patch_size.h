// How many tiles a patch of a world should have along each edge, by what the world's terrain was measured to
// cost. Voxels do not depend on it.
#pragma once

#include <chrono>
#include <cstdint>

#include <talus/terrain/world.h>

#include "runtime/clock.h"

namespace talus::server {

/// Thread time that a tile takes at level 0, of the dearest of a few places each.
struct TileCost {
  std::chrono::nanoseconds terrain{};  // with its halo
  std::chrono::nanoseconds chunk{};    // each of its highest, where objects stand
  std::size_t bytes = 0;               // of its stacks
};
/// Takes no more than a few tiles' time, and allocates as a generator does.
[[nodiscard]] TileCost measure_tile(const terrain::World& world, const Clock& clock);

/// How patches are made, and what one costs.
struct PatchSize {
  int tiles = 0;                         // along each edge
  std::chrono::nanoseconds tile_time{};  // of a lone tile with its halo
  std::chrono::nanoseconds patch_time{};
  bool expensive = false;                 // a patch of kMaxChosenTiles takes longer than kPatchTime
  int halo = 0;                           // columns
  std::chrono::nanoseconds chunk_time{};  // to cut one out of a patch and encode it
  std::size_t tile_bytes = 0;             // of a lone tile's stacks; 0: not measured
  bool reduced = false;                   // it has fewer tiles than time alone would allow

  /// Bytes that a patch in the making takes, with its halo; an estimate.
  [[nodiscard]] std::size_t bytes_in_the_making() const;
  /// Bytes that a generator at work takes, by what a tile was measured to take; an estimate.
  [[nodiscard]] std::size_t bytes_at_work() const;
  /// Thread time for each column of a patch, its halo's included.
  [[nodiscard]] std::uint64_t ns_a_column() const;
  [[nodiscard]] bool chunks_expensive() const;
};

/// A client that needs one chunk of a patch waits for all of it.
inline constexpr std::chrono::milliseconds kPatchTime{50};
/// Of the 2,000 chunks of a View of radius 16, so much each is half a second of a thread.
inline constexpr std::chrono::microseconds kChunkTime{250};
/// Larger patches save little: the halo of most worlds is narrow against four tiles.
inline constexpr int kMaxChosenTiles = 4;

/// A patch of so many tiles, where a lone tile takes `tile_time` and `halo` columns are computed around.
[[nodiscard]] PatchSize patch_size(int tiles, std::chrono::nanoseconds tile_time, int halo);

/// The largest power of two, up to kMaxChosenTiles, whose patch stays within kPatchTime. Where the halo is
/// most of the work, a patch of more tiles hardly takes longer than a tile, and serves many: twice a tile's
/// time is always allowed.
[[nodiscard]] PatchSize choose_patch_size(std::chrono::nanoseconds tile_time, int halo);

/// `size`, or fewer tiles where a generator at work would take more than `most_bytes`: the most that take no
/// more; where none do, the fewest. Never so few that halos would make a column take more than twice the
/// time.
[[nodiscard]] PatchSize reduced_to(std::size_t most_bytes, const PatchSize& size);

}  // namespace talus::server
