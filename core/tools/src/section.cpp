#include "section.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include <talus/terrain/extraction.h>
#include <talus/tools/ordered_work.h>
#include <talus/tools/patch_grid.h>
#include <talus/tools/voxel_grid.h>

#include "section_colours.h"

namespace talus::tools {
namespace {

constexpr int kPatchColumns = 256;

struct RowRun {
  MaterialId material{};
  std::int32_t from = 0;
  std::int32_t to = 0;
};
using Column = std::vector<RowRun>;

// Drawn from the chunks, so that the picture shows everything in them.
std::vector<Column> cut_patch(const terrain::World& world, const terrain::Region& patch,
                              std::int32_t bottom) {
  const std::int32_t top = static_cast<std::int32_t>(highest_row(world, Lod{}));
  const VoxelGrid grid = grid_of_chunks(world, patch, bottom, top - bottom);
  std::vector<Column> columns(patch.columns());
  for (int z = 0; z < patch.depth; ++z) {
    for (int x = 0; x < patch.width; ++x) {
      Column& runs = columns[static_cast<std::size_t>(x + z)];
      const auto voxels = grid.column(x, z);
      for (std::int32_t row = bottom; row < top; ++row) {
        const MaterialId material = voxels[static_cast<std::size_t>(row - bottom)];
        if (material == kAir) continue;
        if (runs.empty() || runs.back().material != material || runs.back().to != row) {
          runs.push_back({material, row, row});
        }
        runs.back().to = row + 1;
      }
    }
  }
  return columns;
}

class SectionPainter {
 public:
  SectionPainter(const terrain::World& world, Image& image, int scale, std::int32_t bottom)
      : lights_{material_lights(world)}, image_{image}, scale_{scale}, bottom_{bottom} {}

  void paint_sky() {
    for (int y = 0; y < image_.height; ++y) {
      const auto colour = sky_colour(static_cast<float>(y) / static_cast<float>(image_.height));
      for (int x = 0; x < image_.width; ++x) image_.set(x, y, colour);
    }
  }

  void paint_column(int column, const Column& runs) {
    std::int32_t above = bottom_;
    for (const RowRun& run : runs) {
      for (std::int32_t row = above; row < run.from; ++row) fill(column, row, kUnderRoof);
      above = run.to;
      const glm::vec3 light = lights_[to_integer(run.material)];
      for (std::int32_t row = run.from; row < run.to; ++row) {
        fill(column, row,
             to_colour(run.material == kWater ? light * daylight_under(static_cast<float>(run.to - row))
                                              : light));
      }
    }
  }

 private:
  void fill(int column, std::int32_t row, terrain::Colour colour) {
    const int left = column * scale_;
    const int under = image_.height - (row - bottom_) * scale_;
    for (int y = under - scale_; y < under; ++y) {
      for (int x = left; x < left + scale_; ++x) image_.set(x, y, colour);
    }
  }

  std::vector<glm::vec3> lights_;
  Image& image_;
  int scale_;
  std::int32_t bottom_;
};

}  // namespace

Expected<Image> render_section(const terrain::World& world, const terrain::Region& line,
                               const SectionOptions& options, ProgressBar& progress) {
  const std::int32_t bottom = -8;
  std::vector<Column> columns;
  const PatchGrid grid{line, kPatchColumns};
  progress.expect(line.columns());
  const auto cut = [&](std::size_t index) { return cut_patch(world, grid.patch(index), bottom); };
  work_in_order(grid.count(), thread_count(options.threads), cut, [&](std::size_t, std::vector<Column> cuts) {
    progress.advance(cuts.size());
    std::move(cuts.begin(), cuts.end(), std::back_inserter(columns));
    return true;
  });

  std::int32_t highest = 0;
  for (const Column& column : columns) {
    if (!column.empty()) highest = std::max(highest, column.back().to);
  }
  const std::int32_t top = highest + std::max(8, highest / 6);
  const std::int64_t width = std::int64_t{line.width} * line.depth * options.scale;
  const std::int64_t height = std::int64_t{top - bottom} * options.scale;
  if (auto fits = check_picture_size("--length, --scale", width, height); !fits) {
    return tl::make_unexpected(fits.error());
  }
  Image image{static_cast<int>(width), static_cast<int>(height)};
  SectionPainter painter{world, image, options.scale, bottom};
  painter.paint_sky();
  for (std::size_t i = 0; i < columns.size(); ++i) painter.paint_column(static_cast<int>(i), columns[i]);
  return image;
}

}  // namespace talus::tools
