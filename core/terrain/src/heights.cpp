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

/// H is a function of the column alone. Whether one opens to the sky takes no more to know than itself and
/// the columns beside.
class HeightsWork::ByColumns final : public HeightsWork::Pieces {
 public:
  ByColumns(const World& world, std::vector<BaseColumn> columns)
      : Pieces{std::move(columns)},
        rows_{make_surface_rows(heights_alone(world), instruction_set())},
        ground_{world, instruction_set(), false},
        carver_{make_carver(world, instruction_set())} {}

  bool step(std::size_t columns) override {
    const std::size_t last = next_ + std::min(columns, columns_.size() - next_);
    for (; next_ < last; ++next_) heights_[next_] = height(columns_[next_]);
    return next_ < columns_.size();
  }

 private:
  std::int32_t height(const BaseColumn& column) {
    std::int32_t height = 0;
    rows_->start({&column.x, 1});
    rows_->row(column.z, &height);
    if (!carver_) return height;
    const Region region{column.x, column.z, 1, 1, Lod{}};
    const int around = carver_->entrance_halo(Lod{});
    ground_.compute(region.expanded(around));
    carver_->compute(region, around, 0, ground_.height());
    const Field& entrances = carver_->entrances();
    const bool opens = !entrances.values.empty() && entrances.values[0] != Carver::kClosed;
    return opens ? entrances.values[0] : height;
  }

  std::unique_ptr<SurfaceRows> rows_;
  Ground ground_;
  std::unique_ptr<Carver> carver_;
  std::size_t next_ = 0;
};

/// The erosion method moves the ground: a region for each tile that holds a column.
class HeightsWork::ByTiles final : public HeightsWork::Pieces {
 public:
  ByTiles(const World& world, std::vector<BaseColumn> columns)
      : Pieces{std::move(columns)}, generator_{world} {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      by_tile_[{floor_div(columns_[i].x, kChunkSize), floor_div(columns_[i].z, kChunkSize)}].push_back(i);
    }
    start_tile();
  }

  bool step(std::size_t columns) override {
    if (by_tile_.empty()) return false;
    if (generator_.step(static_cast<int>(columns))) return true;
    stacks_ = generator_.take();
    for (const std::size_t i : by_tile_.begin()->second) {
      heights_[i] = stacks_.ground_fx(static_cast<int>(columns_[i].x - stacks_.region.x),
                                      static_cast<int>(columns_[i].z - stacks_.region.z));
    }
    by_tile_.erase(by_tile_.begin());
    start_tile();
    return !by_tile_.empty();
  }

 private:
  void start_tile() {
    if (by_tile_.empty()) return;
    const auto& [tile_x, tile_z] = by_tile_.begin()->first;
    generator_.start({tile_x * kChunkSize, tile_z * kChunkSize, kChunkSize, kChunkSize, Lod{}},
                     std::move(stacks_));
  }

  // Tiles to come, the first in work, and the places of their columns.
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<std::size_t>> by_tile_;
  Generator generator_;
  Stacks stacks_;
};

HeightsWork::HeightsWork(const World& world, std::vector<BaseColumn> columns) {
  if (world.spec().method == Method::erosion) {
    pieces_ = std::make_unique<ByTiles>(world, std::move(columns));
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
