// A world: a checked world.toml and everything derived from it before any column is computed. Immutable once
// parsed; threads may share it.
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
#include <talus/terrain/secret.h>
#include <talus/terrain/world_files.h>
#include <talus/voxel/content_hash.h>
#include <talus/voxel/coords.h>
#include <talus/voxel/material.h>

namespace talus::terrain {

/// The rules by which specs become voxels, oldest first; see World::generator_version(). A version's voxels
/// for a spec never change: a rule that gives other voxels belongs to the next version, which applies only to
/// the worlds whose voxels it changes.
enum class GeneratorVersion : std::uint8_t {
  v2 = 2,
  /// Erosion of two or more steps takes fewer steps at coarse levels. Adds surfaces of kind "regions",
  /// materials by place, talus and objects.
  v3 = 3,
};
inline constexpr GeneratorVersion kNewestGeneratorVersion = GeneratorVersion::v3;
[[nodiscard]] constexpr int to_integer(GeneratorVersion version) {
  return static_cast<int>(version);
}

/// Heights are int32 in 1/256 voxel; names of such values end in _fx.
inline constexpr int kSubvoxels = 256;

struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  bool operator==(const Colour&) const = default;
};

/// The source of the surface's heights.
enum class SurfaceKind : std::uint8_t { perlin, ridged, warped, height_map, regions };

/// The land outside of a height map.
enum class Outside : std::uint8_t { mirror, sea, blend, repeat };

/// A height map and its place. Lengths are in terrain units.
struct HeightMapSpec {
  std::string file;  // as named in the spec
  double x = 0;      // of the first sample
  double z = 0;
  double spacing_x = 0;  // from one sample to the next
  double spacing_z = 0;
  std::optional<double> low;   // sample value at y = 0; set once the world is parsed
  std::optional<double> high;  // sample value at the amplitude; set once the world is parsed
  Outside outside = Outside::mirror;
  double margin = 0;  // width of the transition to the land around, inside the map's edge
  SurfaceKind around = SurfaceKind::perlin;  // if outside is `blend`
  std::shared_ptr<const Field> heights_fx;   // the samples, 0 to amplitude * resolution; set by World::parse
};

/// A surface of noise raised to a power (thesis 3.1), a height map, or regions. Lengths are in terrain units.
struct SurfaceSpec {
  SurfaceKind kind = SurfaceKind::perlin;
  double wavelength = 0;  // of the first octave; 0 without noise
  int octaves = 0;
  double gain = 0;  // h = clamp(0.5 + gain * fBm, 0, 1)^exponent * amplitude
  int exponent = 0;
  double amplitude = 0;
  double feedback = 0;  // ridged: influence of an octave on the next
  double warp = 0;      // warped: maximum displacement of a position
  double warp_wavelength = 0;
  int warp_octaves = 0;
  std::optional<HeightMapSpec> height_map;
  std::optional<RegionsSpec> regions;

  /// The kind of noise of the surface, or of the land around its height map. nullopt if the map is
  /// everything, and for regions.
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
  bool band = false;  // true for the layers that repeat
};

/// Thesis 3.2.2.
struct ErodedSpec {
  std::string name;
  Colour colour;
  double weight = 0;
  std::int64_t thickness_q16 = 0;
  double angle_of_repose = 0;        // degrees
  double max_slope = 0;              // degrees
  std::optional<std::size_t> share;  // index in PlacesSpec::shares
};

/// Talus aprons: loose material shed by cliffs that leans on their feet. Lengths are in terrain units.
struct TalusSpec {
  std::size_t of = 0;    // index of its eroded material; walls are steeper than that material's max_slope
  double thickness = 8;  // maximum thickness of an apron
  double share = 0.75;   // thickness as a part of the height of surrounding rock above its foot
  double reach = 8;      // maximum distance from a wall to its foot
  double cliff = 12;     // range of the quantity `cliff` around a wall
};

/// Placement of loose material: by the slope of the ground (thesis 3.6), which leaves the surface unchanged,
/// or by moving down (3.5), which changes it.
enum class Method : std::uint8_t { slope, erosion };

inline constexpr int kMaxLayerOctaves = 4;  // also the default

/// The contents of world.toml except features, in range and consistent (docs/DESIGN.md, "Bounds").
struct WorldSpec {
  std::uint64_t seed = 0;
  int resolution = 0;               // voxels per terrain unit
  double strata_wavelength = 0;     // terrain units, before roughness shortens it
  std::optional<double> sea_level;  // terrain units above y = 0
  Method method = Method::slope;
  int erosion_steps = 0;  // at level 0; 0 with the slope method
  SurfaceSpec surface;
  bool strata_repeat = false;             // layers lie in the order of the list, and its bands repeat
  int strata_octaves = kMaxLayerOctaves;  // of each layer's noise
  std::vector<StratifiedSpec> stratified;
  std::vector<ErodedSpec> eroded;
  std::vector<FieldSpec> fields;  // with regions: the file's, and shipped ones not redefined by it
  PlacesSpec places;
  std::optional<TalusSpec> talus;
};

class Feature;
struct FeatureKind;

/// Why a spec is refused.
struct SpecError {
  std::string message;  // "FILE:LINE: key: what is wrong; what would be right". One line.
  // The parts of `message`:
  int line = 0;
  int column = 0;    // of the key's value, from 1; 0 if only the line is known
  std::string key;   // "stratified[1].colour"; empty if the fault is of no key
  std::string text;  // without file, line and key
};

/// Material that features put into rock is stratified: it does not move.
enum class MaterialKind : std::uint8_t { air, water, stratified, eroded };

/// A material of the world; its id is its index in World::materials().
struct Material {
  MaterialId id{};
  std::string name;
  Colour colour;
  MaterialKind kind{};
};

/// A material that is never generated but may be placed by edits. It has no id; a store assigns one, for
/// ever. `kind` is its phase: stratified is solid, water liquid, air gas. Not part of the fingerprint.
struct Placeable {
  std::string name;
  Colour colour;
  MaterialKind kind{};
};

/// One layer of the stratified sequence, before adjacent layers of one material are merged (thesis 3.4).
struct StratumSpec {
  MaterialId material{};
  std::int64_t thickness_q16 = 0;
  double roughness = 0;
};

/// An eroded material in the integers used for settling.
struct LooseSpec {
  MaterialId material{};
  double weight = 0;
  std::int32_t t_fx = 0;  // thickness
  std::int32_t S_fx = 0;  // rise over a run of one column above which no material stays
  std::int32_t c_fx = 0;  // largest thickness difference between neighbours at rest

  std::optional<std::size_t> share;         // index in PlacesSpec::shares: the part of t at a column
  int without_aprons_from = Lod::kMax + 1;  // first level too coarse for the aprons made of it

  /// S at a level: where columns are too far apart for aprons, it lies on the walls that aprons would bury.
  [[nodiscard]] std::int32_t steepest_at(Lod lod) const {
    return lod.value() < without_aprons_from ? S_fx : static_cast<std::int32_t>(std::int64_t{S_fx} * 75 / 64);
  }

  /// Thickness in subvoxels of a level.
  [[nodiscard]] std::int32_t thickness_at(Lod lod) const { return t_fx >> lod.value(); }
  /// Thickness at a column with a share of it, 0 to kWholeShare.
  [[nodiscard]] std::int32_t thickness_at(Lod lod, std::int32_t share_of_it) const {
    return static_cast<std::int32_t>(std::int64_t{t_fx} * share_of_it / kWholeShare) >> lod.value();
  }
  /// Columns of surface around a region that it needs: the halo theorem's ceil(t / c).
  [[nodiscard]] int halo_at(Lod lod) const { return (thickness_at(lod) + c_fx - 1) / c_fx; }
};

class World {
 public:
  /// Reads and checks a whole spec. `file` is used only in errors. Without `files` a spec that names a file
  /// is rejected.
  [[nodiscard]] static tl::expected<World, SpecError> parse(std::string_view toml, std::string_view file,
                                                            const WorldFiles& files = {});
  /// Uses `kinds` of features instead of the shipped ones; for tests.
  [[nodiscard]] static tl::expected<World, SpecError> parse(std::string_view toml, std::string_view file,
                                                            const WorldFiles& files,
                                                            std::span<const FeatureKind> kinds);

  /// The same world with its [[veins]] drawn by `key`, and a fingerprint that only the key gives. nullopt if
  /// it has no [[veins]].
  [[nodiscard]] std::optional<World> with_secret_veins(const SecretKey& key,
                                                       SecretView view = SecretView::exposed) const;
  /// True for the result of with_secret_veins().
  [[nodiscard]] bool has_secrets() const { return has_secrets_; }

  [[nodiscard]] const WorldSpec& spec() const { return spec_; }
  /// Folds, caves and so on: one for each section of a known kind, in the order of the known kinds.
  [[nodiscard]] const std::vector<std::shared_ptr<const Feature>>& features() const { return features_; }
  /// Returns true if a feature carves air out of the ground.
  [[nodiscard]] bool has_caves() const;
  /// Returns true if objects stand on the ground.
  [[nodiscard]] bool has_objects() const;
  /// PlacedObject::kind is an index into it.
  [[nodiscard]] std::vector<ObjectKindName> object_kinds() const;
  /// Air, water, stratified, eroded, then features' materials. materials()[to_integer(id)] has that id.
  [[nodiscard]] const std::vector<Material>& materials() const { return materials_; }
  /// Further materials that may be placed, in the order of the spec; all names are unique.
  [[nodiscard]] const std::vector<Placeable>& placeables() const { return placeables_; }
  /// Materials shown in place of a material, by a column's look.
  struct ShownBy {
    std::size_t looks = 0;            // index in PlacesSpec::looks
    std::vector<MaterialId> by_look;  // by_look[0] is the material itself
  };
  /// Null if the material always shows itself. For water only the topmost voxel changes.
  [[nodiscard]] const ShownBy* shown_by(MaterialId material) const;
  /// The depth under the ground of the material that the topmost voxel of a column of level 1 to 6 shows, in
  /// subvoxels of the level. With regions half a base voxel, the mean depth of the voxel's centre at level 0;
  /// otherwise 0.
  [[nodiscard]] std::int32_t shown_depth_fx(Lod lod) const {
    return spec_.surface.regions ? kSubvoxels / 2 >> lod.value() : 0;
  }
  /// By number; look_names()[0] is empty and means no look.
  [[nodiscard]] const std::vector<std::string>& look_names() const { return look_names_; }
  /// The sequence of layers from the bottom up, the same at every column; 1 to 256.
  [[nodiscard]] const std::vector<StratumSpec>& strata() const { return strata_; }
  /// Eroded materials in the order of the spec.
  [[nodiscard]] const std::vector<LooseSpec>& loose() const { return loose_; }
  /// Indices into loose(), heaviest first: bottom up.
  [[nodiscard]] const std::vector<std::size_t>& loose_bottom_up() const { return loose_bottom_up_; }

  /// Columns of surface around a region that its stacks need to be exact, at level 0: the halo theorem's A;
  /// with the erosion method two per step; or the number that a feature reads, if that is larger.
  [[nodiscard]] int halo() const { return halo_; }
  /// Columns that features read at a level.
  [[nodiscard]] int feature_halo(Lod lod) const;
  /// Steps of the erosion method at a level; 0 with the slope method. A step moves material by one column, so
  /// each doubling of the column width halves the steps.
  [[nodiscard]] int erosion_steps_at(Lod lod) const;
  /// Maximum height of the surface before erosion: amplitude * resolution in subvoxels.
  [[nodiscard]] std::int32_t highest_fx() const { return highest_fx_; }
  /// Maximum rise of the surface above highest_fx() by erosion, in subvoxels of any level: heavy material may
  /// creep under light.
  [[nodiscard]] std::int32_t rise_fx() const { return rise_fx_; }
  /// Maximum distance by which features lift or sink a column's strata, in 2^-16 terrain unit.
  [[nodiscard]] std::int64_t max_lift_q16() const { return max_lift_q16_; }
  [[nodiscard]] std::optional<std::int32_t> sea_fx() const { return sea_fx_; }

  /// The oldest version that gives the world its voxels.
  [[nodiscard]] GeneratorVersion generator_version() const;

  /// Everything that decides a voxel, as text with one number per line; equal for specs that give equal
  /// voxels by the same numbers. Excludes names and colours.
  [[nodiscard]] std::string canonical_form() const;
  /// XXH3-128 of canonical_form(), which includes the generator version; with secrets a keyed hash of that.
  [[nodiscard]] ContentHash fingerprint() const { return fingerprint_; }

 private:
  struct Builder;
  World() = default;
  WorldSpec spec_;
  std::vector<std::shared_ptr<const Feature>> features_;
  std::vector<Material> materials_;
  std::vector<Placeable> placeables_;
  std::vector<std::optional<ShownBy>> shown_by_;  // by material; materials past the end show themselves
  std::vector<std::string> look_names_;
  std::vector<StratumSpec> strata_;
  std::vector<LooseSpec> loose_;
  std::vector<std::size_t> loose_bottom_up_;
  int halo_ = 0;
  std::int32_t highest_fx_ = 0;
  std::int32_t rise_fx_ = 0;
  std::int64_t max_lift_q16_ = 0;
  std::optional<std::int32_t> sea_fx_;
  bool has_secrets_ = false;
  ContentHash fingerprint_;
};

/// core/worlds/default.toml, built into the library: the world that programs use without --world.
[[nodiscard]] std::string_view default_world_toml();
[[nodiscard]] const World& default_world();
/// core/worlds/classic.toml, built in too: one noise raised to a power, as in the thesis.
[[nodiscard]] std::string_view classic_world_toml();

}  // namespace talus::terrain
