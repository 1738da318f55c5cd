// A world and its chunks, made here: one small interface over core/terrain for programs that have no server.
// Uses no files, threads or clock.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include <talus/terrain/extraction.h>
#include <talus/terrain/field.h>
#include <talus/terrain/world.h>
#include <talus/voxel/chunk.h>
#include <talus/voxel/coords.h>

namespace talus::local {

using terrain::World;
using SpecProblem = terrain::SpecError;

/// Returns the bytes of a file that a world names, or one line that says why there are none.
using FileReader = std::function<tl::expected<std::vector<std::byte>, std::string>(const std::string& name)>;

/// Reads a world file. Height maps may be .npy, and PNG where the build has libpng; models are .vox. Without
/// `files` a world that names a file is refused.
[[nodiscard]] tl::expected<std::shared_ptr<const World>, SpecProblem> open_world(
    std::span<const std::byte> toml, const FileReader& files = {});

/// Tiles of 32 x 32 columns, in chunk coordinates of a level.
struct Tiles {
  std::int32_t x = 0;
  std::int32_t z = 0;
  int width = 0;  // along x
  int depth = 0;  // along z
  Lod lod;
  [[nodiscard]] bool holds(Lod level, std::int32_t at_x, std::int32_t at_z) const {
    return lod == level && at_x >= x && at_x < x + std::int64_t{width} && at_z >= z &&
           at_z < z + std::int64_t{depth};
  }
};

/// The memory of one thread, for one world. Keeps the tiles made last, as columns without voxels.
class Workspace {
 public:
  /// REQUIRES that the world has no secret veins; open_world() makes none.
  /// `ground_bytes`: for ground that neighbouring tiles share, beyond what the tiles themselves take.
  explicit Workspace(std::shared_ptr<const World> world, std::size_t ground_bytes = std::size_t{64} << 20);
  ~Workspace();
  Workspace(Workspace&&) noexcept;
  Workspace& operator=(Workspace&&) noexcept;

  /// Tiles along an edge of what prepare() makes for a single chunk.
  static constexpr int kPatchTiles = 4;

  /// Makes the columns of the tiles, which lie inside the world (checked_chunk()). False if `cancel` was set;
  /// nothing is kept then.
  bool prepare(const Tiles& tiles, const std::atomic<bool>* cancel = nullptr);
  /// Makes the aligned kPatchTiles x kPatchTiles tiles around a chunk's, unless its tile is kept.
  bool prepare(ChunkKey key, const std::atomic<bool>* cancel = nullptr);

  /// The rows of chunks at a chunk's tile that may be mixed. Prepares the tile.
  [[nodiscard]] terrain::MixedRange rows(ChunkKey key);

  [[nodiscard]] const World& world() const { return *world_; }
  /// The kept tiles' columns. REQUIRES that one of prepare() has returned true.
  [[nodiscard]] const terrain::Stacks& stacks() const;

 private:
  struct Memory;
  std::shared_ptr<const World> world_;
  std::unique_ptr<Memory> memory_;
};

class ChunkSink {
 public:
  virtual ~ChunkSink() = default;
  virtual void take(ChunkKey key, const Chunk& chunk) = 0;
};

/// Makes chunks and gives them to `sink`, those of one patch of columns after another; otherwise in the order
/// of `keys`. Returns how many: fewer than asked if `cancel` was set by the sink or another thread.
std::size_t generate(Workspace& workspace, std::span<const ChunkKey> keys, ChunkSink& sink,
                     const std::atomic<bool>* cancel = nullptr);

/// The ground of a region's columns, in subvoxels (1/256 voxel) of its level: the top of the topmost solid
/// material, without objects. z slowest, then x.
[[nodiscard]] std::vector<std::int32_t> heights(const World& world, const terrain::Region& region);

}  // namespace talus::local
