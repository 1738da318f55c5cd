#include <talus/map/grid_painter.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <utility>

#include <talus/map/light.h>
#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>

#include "cover_looks.h"
#include "map_light.h"
#include "relief.h"
#include "top_colour.h"

namespace talus::map {
namespace {

constexpr std::int64_t kFar = 16;  // base columns; from this distance on no wall is as wide as a pixel
// Maximum number of columns of the level, along a side, generated per column of the grid.
constexpr std::int64_t kDensest = 2;
constexpr int kStackPatch = 128;  // columns of the level

Lod level_of(std::int64_t every) {
  return Lod::of(
      std::min(Lod::kMax, static_cast<int>(std::bit_width(static_cast<std::uint64_t>(every))) - 1));
}

}  // namespace

float exaggeration(float columns_a_pixel) {
  return std::pow(columns_a_pixel, 0.4F);
}

class GridPainter::Work final : public Painting {
 public:
  Work(const GridPainter& painter, const ColumnGrid& grid, Image& image, int x, int y)
      : painter_{painter},
        grid_{grid},
        image_{image},
        x_{x},
        y_{y},
        sampler_{std::in_place, painter.world_, grid.expanded(kReliefRing), painter.looks_->names()} {
    if (painter.source_ == Source::own_slope) slope_sampler_.emplace(painter.world_, grid);
  }

  bool step() override {
    if (sampler_) {
      if (sampler_->step()) return true;
      samples_ = sampler_->take();
      sampler_.reset();
      ground_ = painter_.lifted(samples_.heights_fx, false);
      seen_ = painter_.lifted(samples_.heights_fx, true);
      if (painter_.source_ == Source::stacks) tops_ = painter_.tops_of_stacks(grid_);
      return true;
    }
    if (slope_sampler_) {
      if (slope_sampler_->step()) return true;
      slopes_fx_ = slope_sampler_->take();
      slope_sampler_.reset();
      return true;
    }
    const int end = std::min(grid_.depth, next_row_ + kRowsAStep);
    for (; next_row_ < end; ++next_row_) {
      for (int i = 0; i < grid_.width; ++i) {
        image_.set(x_ + i, y_ + next_row_, to_colour(developed(pixel(i, next_row_))));
      }
    }
    return next_row_ < grid_.depth;
  }

 private:
  [[nodiscard]] glm::vec3 top(int i, int k, std::size_t column) const {
    switch (painter_.source_) {
      case Source::stacks:
        return tops_[static_cast<std::size_t>(k * grid_.width + i)];
      case Source::level_ground:
        return painter_.looks_->level_ground(samples_, column);
      default:
        return painter_.looks_->ground(samples_, column, slopes_fx_.at(i, k));
    }
  }

  [[nodiscard]] glm::vec3 pixel(int i, int k) const {
    const int x = i + kReliefRing;
    const int z = k + kReliefRing;
    const auto column = static_cast<std::size_t>(z * ground_.width + x);
    const glm::vec3 ground = lit(top(i, k, column), light_at(ground_, x, z));
    const auto sea_fx = painter_.world_.sea_fx();
    const std::int64_t depth_fx = sea_fx.value_or(0) - std::int64_t{samples_.heights_fx.at(x, z)};
    if (!sea_fx || depth_fx <= 0) return ground;
    return painter_.water_->over(ground, painter_.looks_->water(samples_, column), depth_fx,
                                 light_at(seen_, x, z));
  }

  const GridPainter& painter_;
  const ColumnGrid grid_;
  Image& image_;
  const int x_;
  const int y_;
  std::optional<ColumnSampler> sampler_;
  std::optional<SlopeSampler> slope_sampler_;
  ColumnSamples samples_;     // with the ring
  terrain::Field slopes_fx_;  // without the ring
  terrain::Field ground_;
  terrain::Field seen_;
  std::vector<glm::vec3> tops_;
  int next_row_ = 0;
};

GridPainter::GridPainter(const terrain::World& world, std::int64_t every, GridColours colours)
    : world_{world},
      every_{every},
      looks_{std::make_unique<const CoverLooks>(world)},
      source_{Source::own_slope},
      lights_{material_lights(world)},
      water_{std::make_unique<const WaterLight>(world)} {
  if (colours == GridColours::told_by_slope) return;
  source_ = every >= kFar && world.look_names().size() > 1 ? Source::level_ground : Source::stacks;
}

GridPainter::~GridPainter() = default;

std::unique_ptr<Painting> GridPainter::start(const ColumnGrid& grid, Image& image, int x, int y) const {
  return std::make_unique<Work>(*this, grid, image, x, y);
}

// In subvoxels of a voxel as wide as the grid's spacing.
terrain::Field GridPainter::lifted(const terrain::Field& heights_fx, bool sea) const {
  const auto every = static_cast<float>(every_);
  const float factor = exaggeration(every) / every;
  terrain::Field field{heights_fx.width, heights_fx.depth};
  for (std::size_t i = 0; i < field.values.size(); ++i) {
    std::int32_t height = heights_fx.values[i];
    if (sea && world_.sea_fx()) height = std::max(height, *world_.sea_fx());
    field.values[i] = static_cast<std::int32_t>(std::lround(static_cast<float>(height) * factor));
  }
  return field;
}

// Generates the grid in squares, or column by column if most of a square would not be used.
std::vector<glm::vec3> GridPainter::tops_of_stacks(const ColumnGrid& grid) const {
  const Lod lod = level_of(every_);
  const bool alone = every_ > kDensest << lod.value();
  const int edge = alone ? 1 : std::max(1, static_cast<int>((kStackPatch << lod.value()) / every_));
  std::vector<glm::vec3> tops(grid.columns());
  terrain::Generator generator{world_};
  terrain::Stacks stacks;
  for (int k = 0; k < grid.depth; k += edge) {
    for (int i = 0; i < grid.width; i += edge) {
      const int last_i = std::min(grid.width, i + edge) - 1;
      const int last_k = std::min(grid.depth, k + edge) - 1;
      const auto at_level = [&](std::int64_t base) { return base >> lod.value(); };
      const std::int64_t x = at_level(grid.x_of(i));
      const std::int64_t z = at_level(grid.z_of(k));
      generator.generate({x, z, static_cast<int>(at_level(grid.x_of(last_i)) - x + 1),
                          static_cast<int>(at_level(grid.z_of(last_k)) - z + 1), lod},
                         stacks);
      const std::vector<MaterialId> outcrops = exposed_overlays(world_, stacks);
      for (int kk = k; kk <= last_k; ++kk) {
        for (int ii = i; ii <= last_i; ++ii) {
          tops[static_cast<std::size_t>(kk * grid.width + ii)] =
              top_colour(world_, stacks, outcrops, lights_, static_cast<int>(at_level(grid.x_of(ii)) - x),
                         static_cast<int>(at_level(grid.z_of(kk)) - z));
        }
      }
    }
  }
  return tops;
}

}  // namespace talus::map
