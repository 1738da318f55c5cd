// The ground of single columns, and a place to stand. Pure; any thread may call.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <talus/terrain/world.h>
#include <talus/voxel/coords.h>

namespace talus::terrain {

/// The ground of single base columns, in subvoxels: H, or a cave's floor where it is open to the sky. With
/// the erosion method each tile of 32 x 32 columns that holds a requested column costs a region of its own
/// with its halo; with caves or talus, the ground around the requested ones.
struct BaseColumn {
  std::int64_t x = 0;
  std::int64_t z = 0;
};
[[nodiscard]] std::vector<std::int32_t> surface_heights(const World& world,
                                                        std::span<const BaseColumn> columns);

/// surface_heights() in pieces, for a caller who holds a clock and may stop between two of them, or give up.
/// The world must outlive it. For one thread at a time.
class HeightsWork {
 public:
  HeightsWork(const World& world, std::vector<BaseColumn> columns);
  ~HeightsWork();
  HeightsWork(HeightsWork&&) noexcept;
  HeightsWork& operator=(HeightsWork&&) noexcept;

  /// One piece: at most `columns` of the columns, or with the erosion method one of Generator::step(). False
  /// when nothing is left. REQUIRES columns > 0.
  bool step(std::size_t columns = kColumnsAPiece);
  static constexpr std::size_t kColumnsAPiece = 256;
  /// One a column, in their order, once step() has returned false.
  [[nodiscard]] std::vector<std::int32_t> take();

 private:
  class Pieces;
  class ByColumns;
  class ByGround;
  class ByTiles;
  std::unique_ptr<Pieces> pieces_;
};

/// A dry, level place near the origin: the voxel in which feet stand, the first free one above the ground. In
/// a world of regions the one, some kilometres around, from which there is most to see: summits, water,
/// trees. Where no ground is dry within reach, on the water. The same world has the same spawn everywhere.
[[nodiscard]] VoxelPos find_spawn(const World& world);

}  // namespace talus::terrain
