#include "erode_height_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include <talus/world_files/world_files.h>

#include "height_map_file.h"

namespace talus::tools {
namespace {

template <class Sample>
Sample sample_of(double height) {
  if constexpr (std::is_floating_point_v<Sample>) {
    return static_cast<Sample>(height);
  } else {
    constexpr double kMin = std::numeric_limits<Sample>::min();
    constexpr double kMax = std::numeric_limits<Sample>::max();
    return static_cast<Sample>(std::floor(std::clamp(height, kMin, kMax) + 0.5));
  }
}

template <class Sample>
Expected<void> erode_samples(const std::filesystem::path& input, int width, int depth,
                             const DropletOptions& options, std::vector<Sample>& samples) {
  HeightGrid grid{width, depth, {samples.begin(), samples.end()}};
  const bool numbers = std::all_of(grid.heights.begin(), grid.heights.end(),
                                   [](double height) { return std::isfinite(height); });
  if (!numbers)
    return failed(input.string() + ": has samples that are not numbers; only numbers are heights");
  ProgressBar progress{"erode-heightmap", "droplets"};
  erode(grid, options, progress);
  std::transform(grid.heights.begin(), grid.heights.end(), samples.begin(), sample_of<Sample>);
  return {};
}

}  // namespace

Expected<void> erode_height_map(const std::filesystem::path& input, const std::filesystem::path& output,
                                const DropletOptions& options) {
  auto map = world_files::read_height_map(input);
  if (!map) return failed(input.string() + ": " + map.error());
  if (auto fits = check_height_map_name(output, *map); !fits) return fits;
  const auto eroded = std::visit(
      [&](auto& samples) { return erode_samples(input, map->width, map->depth, options, samples); },
      map->samples);
  if (!eroded) return eroded;
  return write_height_map(output, *map);
}

}  // namespace talus::tools
