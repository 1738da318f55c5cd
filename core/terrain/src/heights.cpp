// The ground of single columns.
#include <talus/terrain/heights.h>

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include <talus/terrain/generator.h>
#include <talus/terrain/surface.h>

#include "feature.h"
#include "surface/ground.h"
#include "surface/surface_rows.h"

namespace talus::terrain {
namespace {

Surface heights_alone(const World& world) {
  Surface surface = surface_of(world.spec());
  surface.places.reset();
  return surface;
}

}  // namespace

class HeightsWork::Pieces {
 public:
  explicit Pieces(std::vector<BaseColumn> columns)
      : columns_{std::move(columns)}, heights_(columns_.size()) {}
  virtual ~Pieces() = default;
  virtual bool step(std::size_t columns) = 0;
  [[nodiscard]] std::vector<std::int32_t> take() { return std::move(heights_); }

 protected:
  std::vector<BaseColumn> columns_;
  std::vector<std::int32_t> heights_;
};

/// For worlds whose H depends on the column alone.
class HeightsWork::ByColumns final : public HeightsWork::Pieces {
 public:
  ByColumns(const World& world, std::vector<BaseColumn> columns)
      : Pieces{std::move(columns)}, rows_{make_surface_rows(heights_alone(world), instruction_set())} {}

  bool step(std::size_t columns) override {
    const std::size_t last = next_ + std::min(columns, columns_.size() - next_);
    for (; next_ < last; ++next_) {
      rows_->start({&columns_[next_].x, 1});
      rows_->row(columns_[next_].z, &heights_[next_]);
    }
    return next_ < columns_.size();
  }

 private:
  std::unique_ptr<SurfaceRows> rows_;
  std::size_t next_ = 0;
};

/// Groups columns by the tile of 32 x 32 that contains them.
class ColumnsByTile {
 public:
  explicit ColumnsByTile(const std::vector<BaseColumn>& columns) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      tiles_[{floor_div(columns[i].x, kChunkSize), floor_div(columns[i].z, kChunkSize)}].push_back(i);
    }
  }
  using Tile = std::pair<std::int64_t, std::int64_t>;
  [[nodiscard]] bool empty() const { return tiles_.empty(); }
  [[nodiscard]] const Tile& tile() const { return tiles_.begin()->first; }
  /// Indices of the tile's columns.
  [[nodiscard]] const std::vector<std::size_t>& places() const { return tiles_.begin()->second; }
  void next() { tiles_.erase(tiles_.begin()); }

 private:
  std::map<Tile, std::vector<std::size_t>> tiles_;
};

/// For worlds with talus or caves, which need the ground around a column: computes it once per tile.
class HeightsWork::ByGround final : public HeightsWork::Pieces {
 public:
  ByGround(const World& world, std::vector<BaseColumn> columns)
      : Pieces{std::move(columns)},
        tiles_{columns_},
        ground_{world, instruction_set(), false},
        carver_{make_carver(world, instruction_set())} {}

  bool step(std::size_t columns) override {
    // The ground around it makes a tile as expensive as many columns.
    if (columns > 0 && !tiles_.empty()) {
      make_tile();
      tiles_.next();
    }
    return !tiles_.empty();
  }

 private:
  void make_tile() {
    BaseColumn low = columns_[tiles_.places().front()];
    BaseColumn high = low;
    for (const std::size_t i : tiles_.places()) {
      low = {std::min(low.x, columns_[i].x), std::min(low.z, columns_[i].z)};
      high = {std::max(high.x, columns_[i].x), std::max(high.z, columns_[i].z)};
    }
    const Region region{low.x, low.z, static_cast<int>(high.x - low.x) + 1,
                        static_cast<int>(high.z - low.z) + 1, Lod{}};
    const int around = carver_ ? carver_->entrance_halo(Lod{}) : 0;
    ground_.compute(region.expanded(around));
    if (carver_) carver_->compute(region, around, 0, ground_.height());
    for (const std::size_t i : tiles_.places()) {
      const int x = static_cast<int>(columns_[i].x - region.x);
      const int z = static_cast<int>(columns_[i].z - region.z);
      heights_[i] = ground_.height().at(x + around, z + around);
      if (!carver_ || carver_->entrances().values.empty()) continue;
      const std::int32_t opening = carver_->entrances().at(x, z);
      if (opening != Carver::kClosed) heights_[i] = opening;
    }
  }

  ColumnsByTile tiles_;
  Ground ground_;
  std::unique_ptr<Carver> carver_;
};

/// For the erosion method, which moves the ground: generates each tile that contains a column.
class HeightsWork::ByTiles final : public HeightsWork::Pieces {
 public:
  ByTiles(const World& world, std::vector<BaseColumn> columns)
      : Pieces{std::move(columns)}, tiles_{columns_}, generator_{world} {
    start_tile();
  }

  bool step(std::size_t columns) override {
    if (tiles_.empty()) return false;
    if (generator_.step(static_cast<int>(columns))) return true;
    stacks_ = generator_.take();
    for (const std::size_t i : tiles_.places()) {
      heights_[i] = stacks_.ground_fx(static_cast<int>(columns_[i].x - stacks_.region.x),
                                      static_cast<int>(columns_[i].z - stacks_.region.z));
    }
    tiles_.next();
    start_tile();
    return !tiles_.empty();
  }

 private:
  void start_tile() {
    if (tiles_.empty()) return;
    const auto& [tile_x, tile_z] = tiles_.tile();
    generator_.start({tile_x * kChunkSize, tile_z * kChunkSize, kChunkSize, kChunkSize, Lod{}},
                     std::move(stacks_));
  }

  ColumnsByTile tiles_;  // remaining tiles; the first is in work
  Generator generator_;
  Stacks stacks_;
};

HeightsWork::HeightsWork(const World& world, std::vector<BaseColumn> columns) {
  if (world.spec().method == Method::erosion) {
    pieces_ = std::make_unique<ByTiles>(world, std::move(columns));
  } else if (world.spec().talus || world.has_caves()) {
    pieces_ = std::make_unique<ByGround>(world, std::move(columns));
  } else {
    pieces_ = std::make_unique<ByColumns>(world, std::move(columns));
  }
}

HeightsWork::~HeightsWork() = default;
HeightsWork::HeightsWork(HeightsWork&&) noexcept = default;
HeightsWork& HeightsWork::operator=(HeightsWork&&) noexcept = default;

bool HeightsWork::step(std::size_t columns) {
  return pieces_->step(columns);
}

std::vector<std::int32_t> HeightsWork::take() {
  return pieces_->take();
}

std::vector<std::int32_t> surface_heights(const World& world, std::span<const BaseColumn> columns) {
  HeightsWork work{world, {columns.begin(), columns.end()}};
  while (work.step()) {
  }
  return work.take();
}

}  // namespace talus::terrain
