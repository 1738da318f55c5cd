#include "sampled_map.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>

#include "cover_looks.h"
#include "map_light.h"
#include "ordered_work.h"
#include "patch_grid.h"
#include "relief.h"
#include "top_colour.h"

namespace talus::tools {
namespace {

constexpr std::int64_t kFar = 16;  // base columns from which on no wall is as wide as a pixel
// Columns of a level that are generated for one of the grid, along a side, at most.
constexpr std::int64_t kDensest = 2;
constexpr int kStackPatch = 128;  // columns of a level

Lod level_of(std::int64_t every) {
  return Lod::of(
      std::min(Lod::kMax, static_cast<int>(std::bit_width(static_cast<std::uint64_t>(every))) - 1));
}

// Mountains seen from afar are flat; a map of a continent lifts them.
float exaggeration(std::int64_t every) {
  return std::pow(static_cast<float>(every), 0.4F);
}

class SampledPainter {
 public:
  SampledPainter(const terrain::World& world, std::int64_t every)
      : world_{world},
        every_{every},
        looks_{world},
        by_looks_{every >= kFar && world.look_names().size() > 1},
        lights_{material_lights(world)},
        water_{world} {}

  void paint(const ColumnGrid& patch, Image& image, int image_x, int image_y) const {
    const ColumnSamples samples = sample_columns(world_, patch.expanded(kReliefRing), looks_.names());
    const terrain::Field ground = lifted(samples.heights_fx, false);
    const terrain::Field seen = lifted(samples.heights_fx, true);
    const std::vector<glm::vec3> tops = by_looks_ ? std::vector<glm::vec3>{} : tops_of_stacks(patch);
    for (int k = 0; k < patch.depth; ++k) {
      for (int i = 0; i < patch.width; ++i) {
        const int x = i + kReliefRing;
        const int z = k + kReliefRing;
        const auto column = static_cast<std::size_t>(z * ground.width + x);
        const glm::vec3 top =
            by_looks_ ? looks_.ground(samples, column) : tops[static_cast<std::size_t>(k * patch.width + i)];
        glm::vec3 pixel = lit(top, light_at(ground, x, z));
        const std::int64_t depth_fx = world_.sea_fx().value_or(0) - std::int64_t{samples.heights_fx.at(x, z)};
        if (world_.sea_fx() && depth_fx > 0) {
          pixel = water_.over(pixel, looks_.water(samples, column), depth_fx, light_at(seen, x, z));
        }
        image.set(image_x + i, image_y + k, to_colour(developed(pixel)));
      }
    }
  }

 private:
  // Heights as light falls on them, in subvoxels of a voxel that is as large as a pixel's columns.
  terrain::Field lifted(const terrain::Field& heights_fx, bool sea) const {
    const float factor = exaggeration(every_) / static_cast<float>(every_);
    terrain::Field field{heights_fx.width, heights_fx.depth};
    for (std::size_t i = 0; i < field.values.size(); ++i) {
      std::int32_t height = heights_fx.values[i];
      if (sea && world_.sea_fx()) height = std::max(height, *world_.sea_fx());
      field.values[i] = static_cast<std::int32_t>(std::lround(static_cast<float>(height) * factor));
    }
    return field;
  }

  // Over the patch in squares, or column by column where a square would be mostly what nobody asks for.
  std::vector<glm::vec3> tops_of_stacks(const ColumnGrid& patch) const {
    const Lod lod = level_of(every_);
    const bool alone = every_ > kDensest << lod.value();
    const int edge = alone ? 1 : std::max(1, static_cast<int>((kStackPatch << lod.value()) / every_));
    std::vector<glm::vec3> tops(patch.columns());
    terrain::Generator generator{world_};
    terrain::Stacks stacks;
    for (int k = 0; k < patch.depth; k += edge) {
      for (int i = 0; i < patch.width; i += edge) {
        const int last_i = std::min(patch.width, i + edge) - 1;
        const int last_k = std::min(patch.depth, k + edge) - 1;
        const auto at_level = [&](std::int64_t base) { return base >> lod.value(); };
        const std::int64_t x = at_level(patch.x_of(i));
        const std::int64_t z = at_level(patch.z_of(k));
        generator.generate({x, z, static_cast<int>(at_level(patch.x_of(last_i)) - x + 1),
                            static_cast<int>(at_level(patch.z_of(last_k)) - z + 1), lod},
                           stacks);
        const std::vector<MaterialId> outcrops = exposed_overlays(world_, stacks);
        for (int kk = k; kk <= last_k; ++kk) {
          for (int ii = i; ii <= last_i; ++ii) {
            tops[static_cast<std::size_t>(kk * patch.width + ii)] =
                top_colour(world_, stacks, outcrops, lights_, static_cast<int>(at_level(patch.x_of(ii)) - x),
                           static_cast<int>(at_level(patch.z_of(kk)) - z));
          }
        }
      }
    }
    return tops;
  }

  const terrain::World& world_;
  std::int64_t every_;
  CoverLooks looks_;
  bool by_looks_;
  std::vector<glm::vec3> lights_;
  WaterLight water_;
};

}  // namespace

Image render_sampled_map(const terrain::World& world, const ColumnGrid& grid,
                         const SampledMapOptions& options, ProgressBar& progress) {
  Image image{grid.width, grid.depth};
  const PatchGrid patches{{0, 0, grid.width, grid.depth, Lod{}}, options.patch_edge};
  const SampledPainter painter{world, grid.every};
  progress.expect(grid.columns());
  const auto paint = [&](std::size_t index) {
    const terrain::Region patch = patches.patch(index);
    const int x = static_cast<int>(patch.x);
    const int z = static_cast<int>(patch.z);
    painter.paint(grid.part(x, z, patch.width, patch.depth), image, x, z);
    return patch.columns();
  };
  work_in_order(patches.count(), thread_count(options.threads), paint, [&](std::size_t, std::size_t columns) {
    progress.advance(columns);
    return true;
  });
  return image;
}

}  // namespace talus::tools
