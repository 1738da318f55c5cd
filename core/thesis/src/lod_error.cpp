#include "lod_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>

#include <talus/terrain/boundary_row.h>
#include <talus/terrain/extraction.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/stacks.h>
#include <talus/tools/ordered_work.h>
#include <talus/tools/patch_grid.h>
#include <nlohmann/json.hpp>

namespace talus::tools {
namespace {

constexpr int kPatchSide = kSkylineDepth;  // base columns; a multiple of level 6's
constexpr std::size_t kLevels = 6;

// Histogram of a skyline's errors, in sixteenths of the level's voxel.
class SkylineErrors {
 public:
  void add(std::int64_t base_voxels, int level) {
    const std::int64_t sixteenths = 16 * base_voxels >> level;
    ++counts_[static_cast<std::size_t>(std::min<std::int64_t>(sixteenths, counts_.size() - 1))];
  }
  void add(const SkylineErrors& other) {
    for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += other.counts_[i];
  }
  /// The error, in voxels, that `share` of all columns do not exceed.
  [[nodiscard]] double percentile(double share) const {
    const auto all = std::accumulate(counts_.begin(), counts_.end(), std::int64_t{0});
    std::int64_t below = 0;
    std::size_t i = 0;
    while (i + 1 < counts_.size() &&
           static_cast<double>(below + counts_[i]) < share * static_cast<double>(all)) {
      below += counts_[i++];
    }
    return static_cast<double>(i + 1) / 16;
  }

 private:
  std::array<std::int64_t, 512> counts_{};
};

// Integer sums, which do not depend on the order of the patches.
struct Sums {
  std::int64_t surface_fx = 0;
  std::int64_t max_surface_fx = 0;
  std::int64_t rows = 0;
  std::int64_t max_rows = 0;
  std::int64_t same_material = 0;
  std::int64_t elsewhere = 0;  // columns away from widened rivers
  std::int64_t same_elsewhere = 0;
  std::int64_t own = 0;  // base columns, among these, that the level samples
  std::int64_t same_at_own = 0;
  SkylineErrors skyline;

  void add(const Sums& other) {
    surface_fx += other.surface_fx;
    max_surface_fx = std::max(max_surface_fx, other.max_surface_fx);
    rows += other.rows;
    max_rows = std::max(max_rows, other.max_rows);
    same_material += other.same_material;
    elsewhere += other.elsewhere;
    same_elsewhere += other.same_elsewhere;
    own += other.own;
    same_at_own += other.same_at_own;
    skyline.add(other.skyline);
  }
};

class Ground {
 public:
  Ground(const terrain::World& world, const terrain::Region& region)
      : world_{world},
        stacks_{generate_stacks(world, region)},
        ore_{exposed_overlays(world, stacks_)},
        rock_planes_{stacks_.tops.size() - world.loose().size()},
        wet_fx_{terrain::wet_fx(world, region.lod)} {
    if (const auto sea_fx = world.sea_fx()) {
      sea_row_ = terrain::boundary_row(*sea_fx >> region.lod.value());
    }
  }

  [[nodiscard]] std::int64_t height_fx(int x, int z) const { return stacks_.ground_fx(x, z); }
  [[nodiscard]] std::int64_t row(int x, int z) const {
    const std::int64_t row = terrain::boundary_row(stacks_.ground_fx(x, z));
    const bool wet = stacks_.ground_fx(x, z) < wet_fx_ && !stacks_.is_entrance(x, z);
    return wet ? std::min(row, sea_row_ - 1) : row;
  }

  /// Highest rows of the ground or the sea, by x from the south and by z from the west, in base voxels.
  [[nodiscard]] std::array<std::vector<std::int64_t>, 2> skylines() const {
    const terrain::Region& region = stacks_.region;
    std::array<std::vector<std::int64_t>, 2> lines;
    lines[0].resize(static_cast<std::size_t>(region.width));
    lines[1].resize(static_cast<std::size_t>(region.depth));
    for (int z = 0; z < region.depth; ++z) {
      for (int x = 0; x < region.width; ++x) {
        const std::int64_t top = std::max(row(x, z), sea_row_) << region.lod.value();
        auto& from_south = lines[0][static_cast<std::size_t>(x)];
        auto& from_west = lines[1][static_cast<std::size_t>(z)];
        from_south = std::max(from_south, top);
        from_west = std::max(from_west, top);
      }
    }
    return lines;
  }

  // The material of the highest voxel that is not air.
  [[nodiscard]] MaterialId shown(int x, int z) const {
    const std::int32_t top = stacks_.ground_fx(x, z);
    if (row(x, z) < sea_row_ && !stacks_.is_entrance(x, z)) return kWater;
    // At level 0 the material at the voxel's centre; at other levels the material near the top.
    const Lod lod = stacks_.region.lod;
    const std::int32_t centre =
        (terrain::boundary_row(top) - 1) * terrain::kSubvoxels + terrain::kSubvoxels / 2;
    const std::int32_t seen = lod.value() == 0 ? centre : top - 1 - world_.shown_depth_fx(lod);
    std::size_t k = 0;
    while (k + 1 < stacks_.tops.size() && stacks_.tops[k].at(x, z) <= seen) ++k;
    const MaterialId ore = ore_[static_cast<std::size_t>(z) * static_cast<std::size_t>(stacks_.region.width) +
                                static_cast<std::size_t>(x)];
    return k < rock_planes_ && ore != kAir ? ore : stacks_.shown(world_, k, x, z);
  }

 private:
  const terrain::World& world_;
  terrain::Stacks stacks_;
  std::vector<MaterialId> ore_;
  std::size_t rock_planes_;
  std::int32_t wet_fx_;
  std::int64_t sea_row_ = -1;
};

double share(std::int64_t part, std::int64_t all) {
  return all == 0 ? 1 : static_cast<double>(part) / static_cast<double>(all);
}

std::array<Sums, kLevels> compare(const terrain::World& world, const terrain::Region& patch) {
  const Ground base{world, patch};
  const auto base_lines = base.skylines();
  std::array<Sums, kLevels> levels;
  for (std::size_t i = 0; i < kLevels; ++i) {
    const int level = static_cast<int>(i) + 1;
    const Ground coarse{
        world,
        {patch.x >> level, patch.z >> level, patch.width >> level, patch.depth >> level, Lod::of(level)}};
    Sums& sums = levels[i];
    for (int z = 0; z < patch.depth; ++z) {
      for (int x = 0; x < patch.width; ++x) {
        const int cx = x >> level;
        const int cz = z >> level;
        const std::int64_t surface = std::abs((coarse.height_fx(cx, cz) << level) - base.height_fx(x, z));
        const std::int64_t rows = std::abs((coarse.row(cx, cz) << level) - base.row(x, z));
        sums.surface_fx += surface;
        sums.max_surface_fx = std::max(sums.max_surface_fx, surface);
        sums.rows += rows;
        sums.max_rows = std::max(sums.max_rows, rows);
        const int same = coarse.shown(cx, cz) == base.shown(x, z) ? 1 : 0;
        sums.same_material += same;
        // Of a level's changes at its own base column, only wider rivers lower the ground.
        const std::int64_t lowered =
            base.height_fx(cx << level, cz << level) - (coarse.height_fx(cx, cz) << level);
        if (lowered > std::int64_t{terrain::kSubvoxels} << (level - 1)) continue;
        ++sums.elsewhere;
        sums.same_elsewhere += same;
        if (x != cx << level || z != cz << level) continue;
        ++sums.own;
        sums.same_at_own += same;
      }
    }
    const auto lines = coarse.skylines();
    for (std::size_t side = 0; side < lines.size(); ++side) {
      for (std::size_t column = 0; column < base_lines[side].size(); ++column) {
        sums.skyline.add(std::abs(lines[side][column >> level] - base_lines[side][column]), level);
      }
    }
  }
  return levels;
}

}  // namespace

LodError measure_lod_error(const terrain::World& world, const terrain::Region& region, int threads,
                           ProgressBar& progress) {
  const PatchGrid grid{region, kPatchSide};
  progress.expect(region.columns());
  std::array<Sums, kLevels> levels;
  work_in_order(
      grid.count(), thread_count(threads),
      [&](std::size_t index) { return compare(world, grid.patch(index)); },
      [&](std::size_t index, const std::array<Sums, kLevels>& patch) {
        for (std::size_t i = 0; i < kLevels; ++i) levels[i].add(patch[i]);
        progress.advance(grid.patch(index).columns());
        return true;
      });
  LodError error;
  error.side = region.width;
  const auto columns = static_cast<double>(region.columns());
  for (std::size_t i = 0; i < kLevels; ++i) {
    const Sums& sums = levels[i];
    error.rows.push_back(
        {static_cast<int>(i) + 1, static_cast<double>(sums.surface_fx) / terrain::kSubvoxels / columns,
         static_cast<double>(sums.max_surface_fx) / terrain::kSubvoxels,
         static_cast<double>(sums.rows) / columns, static_cast<double>(sums.max_rows),
         static_cast<double>(sums.same_material) / columns, share(sums.same_elsewhere, sums.elsewhere),
         share(sums.same_at_own, sums.own), sums.skyline.percentile(0.95)});
  }
  return error;
}

std::string to_text(const LodError& error) {
  std::array<char, 256> line{};
  std::snprintf(line.data(), line.size(),
                "height against level 0 in base voxels, over %d x %d base columns\n\n", error.side,
                error.side);
  std::string text = line.data();
  text +=
      "               surface             voxels         mean in       same material from above       "
      "skyline,\n"
      "  level     mean  largest      mean  largest   level's voxels    all  off rivers  own column     95 "
      "%\n";
  for (const LodErrorRow& row : error.rows) {
    std::snprintf(line.data(), line.size(),
                  "  %5d  %7.2f  %7.1f   %7.2f  %7.0f  %14.2f  %5.1f %%     %5.1f %%     %5.1f %%  %7.2f\n",
                  row.level, row.mean_surface, row.max_surface, row.mean_voxels, row.max_voxels,
                  std::ldexp(row.mean_voxels, -row.level), 100 * row.same_material, 100 * row.same_elsewhere,
                  100 * row.same_at_own, row.skyline);
    text += line.data();
  }
  return text;
}

std::string to_json(const LodError& error) {
  nlohmann::ordered_json json{{"side", error.side}, {"levels", nlohmann::ordered_json::array()}};
  for (const LodErrorRow& row : error.rows) {
    json["levels"].push_back({{"level", row.level},
                              {"mean_surface_voxels", row.mean_surface},
                              {"most_surface_voxels", row.max_surface},
                              {"mean_voxel_top_voxels", row.mean_voxels},
                              {"most_voxel_top_voxels", row.max_voxels},
                              {"same_material_from_above", row.same_material},
                              {"same_material_away_from_wide_rivers", row.same_elsewhere},
                              {"same_material_at_own_column", row.same_at_own},
                              {"skyline_95_percent_level_voxels", row.skyline}});
  }
  return json.dump(2) + "\n";
}

}  // namespace talus::tools
