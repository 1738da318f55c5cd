// The ground of single columns, and the spawn position. Pure; thread-safe.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <talus/terrain/world.h>
#include <talus/voxel/coords.h>

namespace talus::terrain {

struct BaseColumn {
  std::int64_t x = 0;
  std::int64_t z = 0;
};
/// Returns the ground of base columns in subvoxels: H, or the floor of a cave that is open to the sky. With
/// the erosion method each tile of 32 x 32 columns that holds a requested column costs a region with its
/// halo; with caves or talus it costs the ground around the requested columns.
[[nodiscard]] std::vector<std::int32_t> surface_heights(const World& world,
                                                        std::span<const BaseColumn> columns);

/// surface_heights() in pieces, for a caller that may pause or stop between two pieces. The world must
/// outlive it. Not thread-safe.
class HeightsWork {
 public:
  HeightsWork(const World& world, std::vector<BaseColumn> columns);
  ~HeightsWork();
  HeightsWork(HeightsWork&&) noexcept;
  HeightsWork& operator=(HeightsWork&&) noexcept;

  /// Does one piece: at most `columns` of the columns, or with the erosion method one Generator::step().
  /// False when nothing is left. REQUIRES columns > 0.
  bool step(std::size_t columns = kColumnsAPiece);
  static constexpr std::size_t kColumnsAPiece = 256;
  /// Returns one height per column, in order. REQUIRES that step() has returned false.
  [[nodiscard]] std::vector<std::int32_t> take();

 private:
  class Pieces;
  class ByColumns;
  class ByGround;
  class ByTiles;
  std::unique_ptr<Pieces> pieces_;
};

/// Returns a dry, level place near the origin: the voxel in which feet stand, the first free one above the
/// ground. In a world of regions it is the best view within some kilometres: summits, water, trees. If no
/// ground within reach is dry, it is on the water. The same world has the same spawn on every machine.
[[nodiscard]] VoxelPos find_spawn(const World& world);

}  // namespace talus::terrain
