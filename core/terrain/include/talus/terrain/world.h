// A world: what a checked world.toml says, and everything that follows from it before any column is
// looked at. Immutable once parsed; share it between threads freely.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include <talus/terrain/field.h>
#include <talus/terrain/height_map.h>
#include <talus/terrain/objects.h>
#include <talus/terrain/places_spec.h>
#include <talus/terrain/regions_spec.h>
#include <talus/terrain/world_files.h>
#include <talus/voxel/content_hash.h>
#include <talus/voxel/coords.h>
#include <talus/voxel/material.h>

namespace talus::terrain {

/// The rules by which specs become voxels, oldest first; World::generator_version() has those of a world.
/// What a version says of a spec never changes: a rule that gives other voxels belongs to the next version,
/// and only the worlds whose voxels it changes have that one.
enum class GeneratorVersion : std::uint8_t {
  v2 = 2,
  /// Erosion of two or more steps takes fewer of them at coarse levels. Surfaces of kind "regions", materials
  /// by place, talus and objects.
  v3 = 3,
};
inline constexpr GeneratorVersion kNewestGeneratorVersion = GeneratorVersion::v3;
[[nodiscard]] constexpr int to_integer(GeneratorVersion version) {
  return static_cast<int>(version);
}

/// Heights are int32 in 1/256 voxel; names that hold one end in _fx.
inline constexpr int kSubvoxels = 256;

struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  bool operator==(const Colour&) const = default;
};

/// What gives the surface its heights.
enum class SurfaceKind : std::uint8_t { perlin, ridged, warped, height_map, regions };

/// What lies outside of a height map.
enum class Outside : std::uint8_t { mirror, sea, blend, repeat };

/// A height map and its place. Lengths in terrain units.
struct HeightMapSpec {
  std::string file;  // as the spec names it
  double x = 0;      // of the first sample
  double z = 0;
  double spacing_x = 0;  // from one sample to the next
  double spacing_z = 0;
  std::optional<double> low;   // the sample value that lies at y = 0, and
  std::optional<double> high;  // at the amplitude; both set once the world is parsed
  Outside outside = Outside::mirror;
  double margin = 0;                         // inside its edge: there it gives way to what lies around
  SurfaceKind around = SurfaceKind::perlin;  // where outside is `blend`
  std::shared_ptr<const Field> heights_fx;   // the samples, 0 to amplitude * resolution; set by World::parse
};

/// A surface of noise raised to a power (thesis 3.1), or a height map. Lengths in terrain units.
struct SurfaceSpec {
  SurfaceKind kind = SurfaceKind::perlin;
  double wavelength = 0;  // of the first octave; 0 where there is no noise
  int octaves = 0;
  double gain = 0;  // h = clamp(0.5 + gain * fBm, 0, 1)^exponent * amplitude
  int exponent = 0;
  double amplitude = 0;
  double feedback = 0;  // ridged: how much an octave shows of the next
  double warp = 0;      // warped: how far a position is displaced
  double warp_wavelength = 0;
  int warp_octaves = 0;
  std::optional<HeightMapSpec> height_map;
  std::optional<RegionsSpec> regions;

  /// The kind of noise of one power that the surface has, or has around its height map; none where all is the
  /// map, and for regions.
  [[nodiscard]] std::optional<SurfaceKind> noise() const {
    if (regions) return std::nullopt;
    if (!height_map) return kind;
    return height_map->outside == Outside::blend ? std::optional{height_map->around} : std::nullopt;
  }
};

/// Thesis 3.2.1. `_q16`: integers of 2^-16 terrain unit.
struct StratifiedSpec {
  std::string name;
  Colour colour;
  std::int64_t depth_q16 = 0;
  std::int64_t thickness_q16 = 0;
  double roughness = 0;
  bool band = false;  // one of those that repeat
};

/// Thesis 3.2.2.
struct ErodedSpec {
  std::string name;
  Colour colour;
  double weight = 0;
  std::int64_t thickness_q16 = 0;
  double angle_of_repose = 0;        // degrees
  double max_slope = 0;              // degrees
  std::optional<std::size_t> share;  // of PlacesSpec::shares
};

/// Talus aprons: loose material that cliffs shed and that leans on their feet. Lengths in terrain units.
struct TalusSpec {
  std::size_t of = 0;    // the eroded material that it is; walls are steeper than its max_slope
  double thickness = 8;  // no apron is thicker
  double share = 0.75;   // of the rock around that stands over its foot
  double reach = 8;      // how far from its foot a wall sheds
  double cliff = 12;     // how far from a wall the quantity `cliff` reaches
};

/// How loose material comes to lie: by the slope of the ground (thesis 3.6), which leaves the surface as it
/// is, or by moving down (3.5), which changes it.
enum class Method : std::uint8_t { slope, erosion };

inline constexpr int kMaxLayerOctaves = 4;  // and as many unless a world says otherwise

/// world.toml as it stands but for its features, in range and consistent (docs/DESIGN.md, "Bounds").
struct WorldSpec {
  std::uint64_t seed = 0;
  int resolution = 0;               // voxels per terrain unit
  double strata_wavelength = 0;     // terrain units, before roughness shortens it
  std::optional<double> sea_level;  // terrain units above y = 0
  Method method = Method::slope;
  int erosion_steps = 0;  // at level 0: how far material has moved; 0 for the slope method
  SurfaceSpec surface;
  bool strata_repeat = false;             // layers lie in the order of the list, its bands again and again
  int strata_octaves = kMaxLayerOctaves;  // of the noise that varies a layer
  std::vector<StratifiedSpec> stratified;
  std::vector<ErodedSpec> eroded;
  std::vector<FieldSpec>
      fields;  // of regions: those of the file, and shipped ones that it does not give anew
  PlacesSpec places;
  std::optional<TalusSpec> talus;
};

class Feature;
struct FeatureKind;

/// "FILE:LINE: key: what is wrong; what would be right". One line.
struct SpecError {
  std::string message;
};

/// What features put into rock is stratified: it does not move.
enum class MaterialKind : std::uint8_t { air, water, stratified, eroded };

/// A material of the world; its id is its place in World::materials().
struct Material {
  MaterialId id{};
  std::string name;
  Colour colour;
  MaterialKind kind{};
};

/// A material that is never generated: who edits may place it. It has no id: a store gives it one, for ever.
/// `kind` says its phase: stratified is solid, water liquid, air gas. No part of the fingerprint.
struct Placeable {
  std::string name;
  Colour colour;
  MaterialKind kind{};
};

/// One layer of the stratified sequence, before neighbours of one material are merged (thesis 3.4).
struct StratumSpec {
  MaterialId material{};
  std::int64_t thickness_q16 = 0;
  double roughness = 0;
};

/// An eroded material in the integers that settling works with.
struct LooseSpec {
  MaterialId material{};
  double weight = 0;
  std::int32_t t_fx = 0;  // thickness
  std::int32_t S_fx = 0;  // rise over a run of one column above which nothing stays
  std::int32_t c_fx = 0;  // largest difference of thickness between neighbours at rest

  std::optional<std::size_t> share;         // of PlacesSpec::shares: what part of t there is at a column
  int without_aprons_from = Lod::kMax + 1;  // levels too coarse for the aprons that are made of it

  /// S at a level: where columns are too far apart for aprons, it lies on the walls that these would bury.
  [[nodiscard]] std::int32_t steepest_at(Lod lod) const {
    return lod.value() < without_aprons_from ? S_fx : static_cast<std::int32_t>(std::int64_t{S_fx} * 75 / 64);
  }

  /// Thickness in subvoxels of a level.
  [[nodiscard]] std::int32_t thickness_at(Lod lod) const { return t_fx >> lod.value(); }
  /// The same where there is a share of it, of kWholeShare.
  [[nodiscard]] std::int32_t thickness_at(Lod lod, std::int32_t share_of_it) const {
    return static_cast<std::int32_t>(std::int64_t{t_fx} * share_of_it / kWholeShare) >> lod.value();
  }
  /// Columns of surface around a region that can matter to it: the halo theorem's ceil(t / c).
  [[nodiscard]] int halo_at(Lod lod) const { return (thickness_at(lod) + c_fx - 1) / c_fx; }
};

class World {
 public:
  /// Reads and checks a whole spec. `file` only names the source in errors. Without `files` a spec that names
  /// any is refused.
  [[nodiscard]] static tl::expected<World, SpecError> parse(std::string_view toml, std::string_view file,
                                                            const WorldFiles& files = {});
  /// The same with these kinds of features instead of those that ship with the library; for tests.
  [[nodiscard]] static tl::expected<World, SpecError> parse(std::string_view toml, std::string_view file,
                                                            const WorldFiles& files,
                                                            std::span<const FeatureKind> kinds);

  [[nodiscard]] const WorldSpec& spec() const { return spec_; }
  /// Folds, caves and the like: one for each section that the spec has of those known to the program, in the
  /// order of the known kinds.
  [[nodiscard]] const std::vector<std::shared_ptr<const Feature>>& features() const { return features_; }
  /// Whether a feature carves air out of the ground.
  [[nodiscard]] bool has_caves() const;
  /// Whether objects stand on the ground.
  [[nodiscard]] bool has_objects() const;
  /// PlacedObject::kind is a place in it.
  [[nodiscard]] std::vector<ObjectKindName> object_kinds() const;
  /// Air, water, stratified, eroded, those of features; materials()[to_integer(id)] is the material of that
  /// id.
  [[nodiscard]] const std::vector<Material>& materials() const { return materials_; }
  /// What else may be placed, in the order of the spec; none has the name of another material.
  [[nodiscard]] const std::vector<Placeable>& placeables() const { return placeables_; }
  /// What shows in place of a material, by the look that a column has.
  struct ShownBy {
    std::size_t looks = 0;            // of PlacesSpec::looks
    std::vector<MaterialId> by_look;  // by_look[0] is the material itself
  };
  /// Null where it always shows itself. Of water it is the topmost voxel that shows so.
  [[nodiscard]] const ShownBy* shown_by(MaterialId material) const;
  /// How far under the ground lies what the topmost voxel of a column of level 1 to 6 shows, in subvoxels of
  /// the level. With regions half a base voxel, where the voxel's centre lies on average at level 0; else 0.
  [[nodiscard]] std::int32_t shown_depth_fx(Lod lod) const {
    return spec_.surface.regions ? kSubvoxels / 2 >> lod.value() : 0;
  }
  /// By number; look_names()[0] is empty: no look.
  [[nodiscard]] const std::vector<std::string>& look_names() const { return look_names_; }
  /// The sequence of layers from the bottom up, the same at every column; 1 to 256.
  [[nodiscard]] const std::vector<StratumSpec>& strata() const { return strata_; }
  /// Eroded materials in the order of the spec.
  [[nodiscard]] const std::vector<LooseSpec>& loose() const { return loose_; }
  /// Indices into loose(), heaviest first: the order in which they lie, bottom up.
  [[nodiscard]] const std::vector<std::size_t>& loose_bottom_up() const { return loose_bottom_up_; }

  /// Columns of surface that must be known around a region for its stacks to be exact, at level 0: the
  /// halo theorem's A; with the erosion method two for every step; as many as a feature reads if those are
  /// more.
  [[nodiscard]] int halo() const { return halo_; }
  /// Those that features read at a level.
  [[nodiscard]] int feature_halo(Lod lod) const;
  /// Steps of the erosion method at a level, 0 with the slope method. A step moves material by one column, so
  /// half as many go as far where columns are twice as wide.
  [[nodiscard]] int erosion_steps_at(Lod lod) const;
  /// No surface is higher before erosion: amplitude * resolution in subvoxels.
  [[nodiscard]] std::int32_t highest_fx() const { return highest_fx_; }
  /// How far erosion can lift a surface above that, in subvoxels of any level: where heavy material creeps
  /// under light.
  [[nodiscard]] std::int32_t rise_fx() const { return rise_fx_; }
  /// No column's strata are lifted or sunk farther by features, in 2^-16 terrain unit.
  [[nodiscard]] std::int64_t max_lift_q16() const { return max_lift_q16_; }
  [[nodiscard]] std::optional<std::int32_t> sea_fx() const { return sea_fx_; }

  /// The oldest version that gives the world its voxels.
  [[nodiscard]] GeneratorVersion generator_version() const;

  /// Everything that decides a voxel, as text with one number a line; equal for specs that give equal
  /// voxels by the same numbers. Names and colours are not in it.
  [[nodiscard]] std::string canonical_form() const;
  /// XXH3-128 of canonical_form(), which names the world's generator version.
  [[nodiscard]] ContentHash fingerprint() const { return fingerprint_; }

 private:
  struct Builder;
  World() = default;
  WorldSpec spec_;
  std::vector<std::shared_ptr<const Feature>> features_;
  std::vector<Material> materials_;
  std::vector<Placeable> placeables_;
  std::vector<std::optional<ShownBy>> shown_by_;  // by material; shorter where the rest shows itself
  std::vector<std::string> look_names_;
  std::vector<StratumSpec> strata_;
  std::vector<LooseSpec> loose_;
  std::vector<std::size_t> loose_bottom_up_;
  int halo_ = 0;
  std::int32_t highest_fx_ = 0;
  std::int32_t rise_fx_ = 0;
  std::int64_t max_lift_q16_ = 0;
  std::optional<std::int32_t> sea_fx_;
  ContentHash fingerprint_;
};

/// core/worlds/default.toml, built into the library: the world that programs use without --world.
[[nodiscard]] std::string_view default_world_toml();
[[nodiscard]] const World& default_world();
/// core/worlds/classic.toml, likewise: one noise raised to a power, as the thesis has it.
[[nodiscard]] std::string_view classic_world_toml();

}  // namespace talus::terrain
