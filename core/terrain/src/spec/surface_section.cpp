#include "spec/surface_section.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <talus/terrain/surface.h>
#include <talus/toml/toml_error.h>

#include "spec/regions_section.h"
#include "spec/units.h"
#include "surface/scaled_heights.h"

namespace talus::terrain {
namespace {

constexpr double kMaxPlace = 68719476736;  // 2^36: terrain units and voxels, the world's end
constexpr double kMaxSample = 1e18;        // maximum sample of a height map
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
  const Range places{-kMaxPlace, kMaxPlace};
  const Voxels spacings{resolution, {1, kMaxSpacing}};
  spec.x = map.length("x", places, {resolution, places});
  spec.z = map.length("z", places, {resolution, places});
  spec.spacing_x = map.length("spacing", {kMinLength, kMaxLength}, spacings);
  spec.spacing_z =
      map.has("spacing_z") ? map.length("spacing_z", {kMinLength, kMaxLength}, spacings) : spec.spacing_x;
  if (map.has("low")) spec.low = map.real("low", {-kMaxSample, kMaxSample});
  if (map.has("high")) spec.high = map.real("high", {-kMaxSample, kMaxSample});
  if (spec.outside == Outside::blend) {
    spec.margin = map.length("margin", {kMinLength, kMaxLength}, {resolution, {1, kMaxMargin}});
    if (map.has("around")) {
      spec.around = static_cast<SurfaceKind>(map.choice("around", {"perlin", "ridged", "warped"}));
    }
  }
  return spec;
}

void read_noise(TableReader& surface, SurfaceKind kind, int resolution, SurfaceSpec& spec) {
  spec.wavelength =
      surface.length("wavelength", {kMinLength, kMaxLength}, {resolution, {2, kMaxLength}, true});
  spec.octaves = static_cast<int>(surface.integer("octaves", 1, 16));
  spec.gain = surface.real("gain", {0, kMaxGain});
  spec.exponent = static_cast<int>(surface.integer("exponent", 1, 8));
  if (kind == SurfaceKind::ridged) {
    spec.feedback = surface.has("feedback") ? surface.real("feedback", {0, 16}) : 2;
  }
  if (kind != SurfaceKind::warped) return;
  spec.warp = surface.length("warp", {0, kMaxWarp}, {resolution, {0, kMaxWarp}});
  spec.warp_wavelength =
      surface.has("warp_wavelength")
          ? surface.length("warp_wavelength", {kMinLength, kMaxLength}, {resolution, {2, kMaxLength}})
          : spec.wavelength;
  spec.warp_octaves =
      surface.has("warp_octaves") ? static_cast<int>(surface.integer("warp_octaves", 1, 16)) : 3;
}

}  // namespace

void read_surface(TableReader root, TableReader surface, const std::vector<FieldSpec>& fields,
                  WorldSpec& world) {
  SurfaceSpec& spec = world.surface;
  if (surface.has("kind")) {
    spec.kind = static_cast<SurfaceKind>(
        surface.choice("kind", {"perlin", "ridged", "warped", "height_map", "regions"}));
  }
  if (spec.kind == SurfaceKind::regions) {
    std::vector<std::string_view> known = region_tables();
    known.push_back("kind");
    surface.only(known);
    spec.regions = read_regions(fields, surface, world.resolution, world.places);
    return;
  }
  if (root.has("field"))
    root.fail("field", "is for surface.kind = \"regions\"; leave it out or choose that kind");
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

  spec.amplitude =
      surface.length("amplitude", {kMinUnits_q16, kMaxHeight}, {world.resolution, {0, kMaxHeight}});
  if (noise) read_noise(surface, *noise, world.resolution, spec);
}

void load_height_map(TableReader surface, WorldSpec& spec, const LoadHeightMap& load) {
  if (!spec.surface.height_map) return;
  HeightMapSpec& map = *spec.surface.height_map;
  auto table = surface.table("height_map");
  const auto refuse = [&](const std::string& why) {
    table->fail("file", "'" + shortened(map.file, 200) + "': " + why);
  };
  if (!load) return refuse("height maps cannot be read here; give a spec without one");
  const auto samples = load(map.file);
  if (!samples) return refuse(samples.error());
  auto heights = scaled_heights(*samples, highest_height_fx(surface_of(spec)), map.low, map.high);
  if (!heights) {
    const HeightsFault& fault = heights.error();
    return fault.key == "file" ? refuse(fault.what) : table->fail(fault.key, fault.what);
  }
  map.heights_fx = *std::move(heights);
}

}  // namespace talus::terrain
