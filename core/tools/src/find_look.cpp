#include "find_look.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>

#include <talus/voxel/coords.h>

#include <talus/map/column_grid.h>

namespace talus::tools {
namespace {

constexpr std::int64_t kEveryColumn = 256;  // up to this distance
constexpr int kShareSide = 512;

bool in_world(std::int64_t base) {
  const std::int64_t limit = chunk_limit(Lod{}) * kChunkSize;
  return base >= -limit && base < limit;
}

class LookSearch {
 public:
  LookSearch(const terrain::World& world, std::uint8_t look, std::int64_t x, std::int64_t z)
      : world_{world}, look_{look}, x_{x}, z_{z} {}

  // Checks the grid's columns at most `within` away along x and z.
  void visit(const map::ColumnGrid& grid, std::int64_t within) {
    const map::ColumnSamples samples = map::sample_columns(world_, grid);
    for (int k = 0; k < grid.depth; ++k) {
      for (int i = 0; i < grid.width; ++i) {
        if (samples.looks.at(i, k) == look_) consider(grid.x_of(i), grid.z_of(k), within);
      }
    }
  }

  // Searches the gaps between the columns of the grid that found it for a nearer one.
  void refine(std::int64_t spacing, std::int64_t within) {
    while (best_ && spacing > 1) {
      const std::int64_t finer = (spacing + 1) / 2;
      const int reach = 4;
      visit(map::grid_around(best_->x, best_->z, finer, 2 * reach + 1, 2 * reach + 1), within);
      spacing = finer;
    }
  }

  [[nodiscard]] const std::optional<FoundColumn>& best() const { return best_; }
  [[nodiscard]] double distance() const { return std::sqrt(square_); }

 private:
  // Distances fit: no side exceeds the world's.
  void consider(std::int64_t x, std::int64_t z, std::int64_t within) {
    const std::int64_t dx = x - x_;
    const std::int64_t dz = z - z_;
    if (std::max(std::abs(dx), std::abs(dz)) > within || !in_world(x) || !in_world(z)) return;
    const double square =
        static_cast<double>(dx) * static_cast<double>(dx) + static_cast<double>(dz) * static_cast<double>(dz);
    if (best_ && square >= square_) return;
    square_ = square;
    best_ = FoundColumn{x, z};
  }

  const terrain::World& world_;
  std::uint8_t look_;
  std::int64_t x_;
  std::int64_t z_;
  double square_ = 0;  // of the distance to the best
  std::optional<FoundColumn> best_;
};

}  // namespace

std::optional<FoundColumn> find_look(const terrain::World& world, std::uint8_t look, std::int64_t x,
                                     std::int64_t z, std::int64_t within, ProgressBar& progress) {
  LookSearch search{world, look, x, z};
  std::uint64_t rings = 1;
  for (std::int64_t reach = kEveryColumn; reach < within; reach *= 2) ++rings;
  progress.expect(rings);
  // A square is processed in four pieces, so that the first has no hole and the others no middle: each ring
  // is the part of its square outside the previous one.
  std::int64_t inner = 0;
  for (std::int64_t reach = kEveryColumn, spacing = 1;; reach *= 2, spacing *= 2) {
    const auto half = static_cast<int>(std::min(reach, (within / spacing) * spacing) / spacing);
    const auto gap = static_cast<int>(inner / spacing);
    const int side = 2 * half + 1;
    const map::ColumnGrid all = map::grid_around(x, z, spacing, side, side);
    if (gap == 0) {
      search.visit(all, within);
    } else if (half > gap) {
      const int rim = half - gap;
      search.visit(all.part(0, 0, side, rim), within);
      search.visit(all.part(0, side - rim, side, rim), within);
      search.visit(all.part(0, rim, rim, side - 2 * rim), within);
      search.visit(all.part(side - rim, rim, rim, side - 2 * rim), within);
    }
    progress.advance(1);
    // A corner of the square is farther away than columns of the next square's sides.
    if ((search.best() && search.distance() <= static_cast<double>(reach)) || reach >= within) {
      search.refine(spacing, within);
      return search.best();
    }
    inner = reach;
  }
}

std::vector<double> look_shares(const terrain::World& world, std::int64_t x, std::int64_t z,
                                std::int64_t within) {
  const std::int64_t every = std::max<std::int64_t>(1, 2 * within / kShareSide);
  const auto side = static_cast<int>(std::min<std::int64_t>(kShareSide, 2 * within + 1));
  const map::ColumnSamples samples = map::sample_columns(world, map::grid_around(x, z, every, side, side));
  std::vector<double> shares(world.look_names().size());
  for (const std::uint8_t look : samples.looks.values) {
    shares[look] += 1.0 / static_cast<double>(samples.looks.values.size());
  }
  return shares;
}

}  // namespace talus::tools
