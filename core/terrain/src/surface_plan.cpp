#include "surface_plan.h"

#include <cmath>

#include <talus/terrain/surface.h>

namespace talus::terrain {
namespace {

constexpr double kMaxWarp = 16384;            // voxels: 2^22 subvoxels
constexpr double kMaxPeriod = 16777216;       // voxels
constexpr double kFarthestMap = 68719476736;  // voxels: the world's end
constexpr double kMaxSpacing = 4096;          // voxels
constexpr double kMaxMargin = 1048576;        // voxels

std::optional<SpecFault> complete_map(HeightMapSpec& map, const WorldSpec& spec, const SpecLines& lines,
                                      const LoadHeightMap& load) {
  const std::string table = "surface.height_map";
  const int line = lines.height_map;
  const auto check = [&](const std::string& key, double units, double least, double most) {
    return out_of_range(line, table, key, units, spec.resolution, least, most);
  };
  if (auto fault = check("x", map.x, -kFarthestMap, kFarthestMap)) return fault;
  if (auto fault = check("z", map.z, -kFarthestMap, kFarthestMap)) return fault;
  if (auto fault = check("spacing", map.spacing_x, 1, kMaxSpacing)) return fault;
  if (auto fault = check("spacing_z", map.spacing_z, 1, kMaxSpacing)) return fault;
  if (map.outside == Outside::blend) {
    if (auto fault = check("margin", map.margin, 1, kMaxMargin)) return fault;
  }
  const auto refuse = [&](const std::string& why) {
    return SpecFault{line, table + ".file", "'" + map.file + "': " + why};
  };
  if (!load) return refuse("height maps cannot be read here; give a spec without one");
  const auto samples = load(map.file);
  if (!samples) return refuse(samples.error());
  const auto highest_fx = static_cast<std::int32_t>(std::floor(surface_of(spec).highest_fx + 0.5F));
  auto heights = scaled_heights(*samples, highest_fx, map.low, map.high);
  if (!heights) return refuse(heights.error());
  map.heights_fx = *std::move(heights);
  return std::nullopt;
}

}  // namespace

std::optional<SpecFault> complete_surface(WorldSpec& spec, const SpecLines& lines,
                                          const LoadHeightMap& load) {
  SurfaceSpec& surface = spec.surface;
  if (surface.noise() == SurfaceKind::warped) {
    if (auto fault =
            out_of_range(lines.warp, "surface", "warp", surface.warp, spec.resolution, 0, kMaxWarp)) {
      return fault;
    }
    if (auto fault = out_of_range(lines.warp, "surface", "warp_wavelength", surface.warp_wavelength,
                                  spec.resolution, 2, kMaxPeriod)) {
      return fault;
    }
  }
  if (!surface.height_map) return std::nullopt;
  return complete_map(*surface.height_map, spec, lines, load);
}

}  // namespace talus::terrain
