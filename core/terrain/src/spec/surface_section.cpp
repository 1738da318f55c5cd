#include "spec/surface_section.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <talus/terrain/surface.h>

#include "spec/units.h"
#include "surface/scaled_heights.h"

namespace talus::terrain {
namespace {

constexpr double kMaxPlace = 68719476736;  // 2^36: terrain units and voxels, the world's end
constexpr double kMaxSample = 1e18;        // of a height map
constexpr double kMaxSpacing = 4096;       // voxels
constexpr double kMaxMargin = 1048576;     // voxels
constexpr double kMaxWarp = 16384;         // terrain units and voxels: 2^22 subvoxels
constexpr double kMaxGain = 16;
constexpr std::size_t kMaxFileNameBytes = 1024;

HeightMapSpec read_height_map(TableReader& map, int resolution) {
  HeightMapSpec spec;
  spec.outside = static_cast<Outside>(map.choice("outside", {"mirror", "sea", "blend", "repeat"}));
  std::vector<std::string_view> known{"file", "x", "z", "spacing", "spacing_z", "low", "high", "outside"};
  if (spec.outside == Outside::blend) known.insert(known.end(), {"margin", "around"});
  map.only(known);
  spec.file = map.text("file", kMaxFileNameBytes);
  spec.x = map.real("x", {-kMaxPlace, kMaxPlace});
  spec.z = map.real("z", {-kMaxPlace, kMaxPlace});
  spec.spacing_x = map.real("spacing", {kMinLength, kMaxLength});
  spec.spacing_z = map.has("spacing_z") ? map.real("spacing_z", {kMinLength, kMaxLength}) : spec.spacing_x;
  if (map.has("low")) spec.low = map.real("low", {-kMaxSample, kMaxSample});
  if (map.has("high")) spec.high = map.real("high", {-kMaxSample, kMaxSample});
  if (spec.outside == Outside::blend) {
    spec.margin = map.real("margin", {kMinLength, kMaxLength});
    if (map.has("around")) {
      spec.around = static_cast<SurfaceKind>(map.choice("around", {"perlin", "ridged", "warped"}));
    }
  }
  map.check_voxels("x", spec.x, resolution, {-kMaxPlace, kMaxPlace});
  map.check_voxels("z", spec.z, resolution, {-kMaxPlace, kMaxPlace});
  map.check_voxels("spacing", spec.spacing_x, resolution, {1, kMaxSpacing});
  map.check_voxels("spacing_z", spec.spacing_z, resolution, {1, kMaxSpacing});
  if (spec.outside == Outside::blend) map.check_voxels("margin", spec.margin, resolution, {1, kMaxMargin});
  return spec;
}

void read_noise(TableReader& surface, SurfaceKind kind, int resolution, SurfaceSpec& spec) {
  spec.wavelength = surface.real("wavelength", {kMinLength, kMaxLength});
  const std::int64_t period = rounded(spec.wavelength * resolution);
  if (period < 2 || period > static_cast<std::int64_t>(kMaxLength)) {
    surface.fail("wavelength", text_of("wavelength * resolution is ", period, " voxels; 2 to ",
                                       static_cast<std::int64_t>(kMaxLength)));
  }
  spec.octaves = static_cast<int>(surface.integer("octaves", 1, 16));
  spec.gain = surface.real("gain", {0, kMaxGain});
  spec.exponent = static_cast<int>(surface.integer("exponent", 1, 8));
  if (kind == SurfaceKind::ridged) {
    spec.feedback = surface.has("feedback") ? surface.real("feedback", {0, 16}) : 2;
  }
  if (kind != SurfaceKind::warped) return;
  spec.warp = surface.real("warp", {0, kMaxWarp});
  surface.check_voxels("warp", spec.warp, resolution, {0, kMaxWarp});
  spec.warp_wavelength = surface.has("warp_wavelength")
                             ? surface.real("warp_wavelength", {kMinLength, kMaxLength})
                             : spec.wavelength;
  surface.check_voxels("warp_wavelength", spec.warp_wavelength, resolution, {2, kMaxLength});
  spec.warp_octaves =
      surface.has("warp_octaves") ? static_cast<int>(surface.integer("warp_octaves", 1, 16)) : 3;
}

}  // namespace

void read_surface(TableReader surface, WorldSpec& world) {
  SurfaceSpec& spec = world.surface;
  if (surface.has("kind")) {
    spec.kind =
        static_cast<SurfaceKind>(surface.choice("kind", {"perlin", "ridged", "warped", "height_map"}));
  }
  if (spec.kind == SurfaceKind::height_map) {
    auto map = surface.table("height_map");
    if (!map) return;
    spec.height_map = read_height_map(*map, world.resolution);
  }
  const auto noise = spec.noise();
  std::vector<std::string_view> known;
  if (noise) known = {"wavelength", "octaves", "gain", "exponent"};
  known.insert(known.end(), {"amplitude", "kind"});
  if (spec.height_map) known.push_back("height_map");
  if (noise == SurfaceKind::ridged) known.push_back("feedback");
  if (noise == SurfaceKind::warped) known.insert(known.end(), {"warp", "warp_wavelength", "warp_octaves"});
  surface.only(known);

  spec.amplitude = surface.real("amplitude", {kMinUnits_q16, kMaxHeight});
  if (spec.amplitude * world.resolution > kMaxHeight) {
    surface.fail("amplitude", text_of("amplitude * resolution is ", spec.amplitude * world.resolution,
                                      " voxels; at most ", kMaxHeight));
  }
  if (noise) read_noise(surface, *noise, world.resolution, spec);
}

void load_height_map(TableReader surface, WorldSpec& spec, const LoadHeightMap& load) {
  if (!spec.surface.height_map) return;
  HeightMapSpec& map = *spec.surface.height_map;
  auto table = surface.table("height_map");
  const auto refuse = [&](const std::string& why) { table->fail("file", "'" + map.file + "': " + why); };
  if (!load) return refuse("height maps cannot be read here; give a spec without one");
  const auto samples = load(map.file);
  if (!samples) return refuse(samples.error());
  auto heights = scaled_heights(*samples, highest_height_fx(surface_of(spec)), map.low, map.high);
  if (!heights) return refuse(heights.error());
  map.heights_fx = *std::move(heights);
}

}  // namespace talus::terrain
