// Drawing of map tiles.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include <talus/map/grid_painter.h>
#include <talus/map/image.h>
#include <talus/map/painting.h>
#include <talus/map/region_painter.h>
#include <talus/map/tile.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/world.h>

namespace talus::map {

/// Draws one tile in pieces. Neighbouring tiles join without a seam, and all zooms have the same light. Tiles
/// of zoom 6 and above are drawn from terrain generated at that level; below, columns are sampled. `world`
/// must outlive this.
class TilePainting final : public Painting {
 public:
  TilePainting(const terrain::World& world, const Tile& tile);
  bool step() override;
  /// REQUIRES that step() has returned false.
  [[nodiscard]] Image take() { return std::move(image_); }

  /// Maximum number of columns in work at once, with their ring, for memory budgets.
  static constexpr int kColumnsAtOnce = (128 + 2 * kReliefRing) * (128 + 2 * kReliefRing);

 private:
  [[nodiscard]] std::unique_ptr<Painting> start(int piece);

  const Tile tile_;
  std::optional<RegionPainter> near_;
  std::optional<GridPainter> far_;
  terrain::Generator generator_;
  Image image_{kTilePixels, kTilePixels};
  int next_piece_ = 0;
  std::unique_ptr<Painting> piece_;
};

}  // namespace talus::map
