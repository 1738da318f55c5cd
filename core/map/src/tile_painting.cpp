#include <talus/map/tile_painting.h>

#include <talus/voxel/coords.h>

namespace talus::map {
namespace {

constexpr int kPiece = 128;  // pixels a side
constexpr int kPiecesASide = kTilePixels / kPiece;
constexpr int kFarthestGenerated = kMaxZoom - Lod::kMax;  // the zoom of the coarsest level

Lod level_of(const Tile& tile) {
  return Lod::of(kMaxZoom - tile.zoom);
}

}  // namespace

TilePainting::TilePainting(const terrain::World& world, const Tile& tile) : tile_{tile}, generator_{world} {
  const std::int64_t every = tile.columns_a_pixel();
  if (tile.zoom >= kFarthestGenerated) {
    near_.emplace(world, level_of(tile), exaggeration(static_cast<float>(every)));
  } else {
    far_.emplace(world, every, GridColours::told_by_slope);
  }
}

bool TilePainting::step() {
  if (piece_ == nullptr) piece_ = start(next_piece_++);
  if (piece_->step()) return true;
  piece_.reset();
  return next_piece_ < kPiecesASide * kPiecesASide;
}

std::unique_ptr<Painting> TilePainting::start(int piece) {
  const int x = piece % kPiecesASide * kPiece;
  const int z = piece / kPiecesASide * kPiece;
  const std::int64_t column_x = tile_.x * kTilePixels + x;
  const std::int64_t column_z = tile_.z * kTilePixels + z;
  if (near_)
    return near_->start(generator_, {column_x, column_z, kPiece, kPiece, level_of(tile_)}, image_, x, z);
  const std::int64_t every = tile_.columns_a_pixel();
  return far_->start({column_x * every, column_z * every, every, kPiece, kPiece}, image_, x, z);
}

}  // namespace talus::map
