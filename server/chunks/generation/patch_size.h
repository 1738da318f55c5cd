// Chooses how many tiles a patch of a world has along each edge, by the measured cost of the world's terrain.
// Voxels do not depend on it.
#pragma once

#include <chrono>
#include <cstdint>

#include <talus/terrain/world.h>

#include "runtime/clock.h"

namespace talus::server {

/// Thread time that a tile takes at level 0: the most expensive of a few places each.
struct TileCost {
  std::chrono::nanoseconds terrain{};  // with its halo
  std::chrono::nanoseconds chunk{};    // each of the highest chunks, which have objects
  std::size_t bytes = 0;               // of the tile's stacks
};
/// Measures the time of a few tiles at most, and allocates as a generator does.
[[nodiscard]] TileCost measure_tile(const terrain::World& world, const Clock& clock);

/// The size of patches, and their cost.
struct PatchSize {
  int tiles = 0;                         // along each edge
  std::chrono::nanoseconds tile_time{};  // for one tile alone, with its halo
  std::chrono::nanoseconds patch_time{};
  bool expensive = false;                 // a patch of kMaxChosenTiles takes longer than kPatchTime
  int halo = 0;                           // columns
  std::chrono::nanoseconds chunk_time{};  // to cut one out of a patch and encode it
  std::size_t tile_bytes = 0;             // stacks of one tile alone; 0: not measured
  bool reduced = false;                   // it has fewer tiles than time alone would allow

  /// Estimates the bytes of a patch in the making, with its halo.
  [[nodiscard]] std::size_t bytes_in_the_making() const;
  /// Estimates the bytes of a generator at work, by the measured bytes of a tile.
  [[nodiscard]] std::size_t bytes_at_work() const;
  /// Returns the thread time for each column of a patch, including its halo's.
  [[nodiscard]] std::uint64_t ns_a_column() const;
  [[nodiscard]] bool chunks_expensive() const;
};

/// A client that needs one chunk of a patch waits for all of it.
inline constexpr std::chrono::milliseconds kPatchTime{50};
/// Time for each of the 2,000 chunks of a View of radius 16; all of them take a thread half a second.
inline constexpr std::chrono::microseconds kChunkTime{250};
/// Larger patches save little: the halo of most worlds is narrow compared with four tiles.
inline constexpr int kMaxChosenTiles = 4;

/// Returns the cost of a patch of `tiles` tiles an edge, if one tile alone takes `tile_time` and its halo has
/// `halo` columns.
[[nodiscard]] PatchSize patch_size(int tiles, std::chrono::nanoseconds tile_time, int halo);

/// Returns the largest power of two, up to kMaxChosenTiles, whose patch stays within kPatchTime. If the halo
/// is most of the work, a patch of more tiles hardly takes longer than a tile, and serves many chunks: twice
/// a tile's time is always allowed.
[[nodiscard]] PatchSize choose_patch_size(std::chrono::nanoseconds tile_time, int halo);

/// Returns `size`, or fewer tiles if a generator at work would take more than `max_bytes`: the most tiles
/// that take no more; if no number does, the fewest. Never so few that halos would make a column take more
/// than twice the time.
[[nodiscard]] PatchSize reduced_to(std::size_t max_bytes, const PatchSize& size);

}  // namespace talus::server
