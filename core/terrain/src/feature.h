// What a kind of feature is made of: folds, faults, ores and caves each are one file in features/, and so is
// the next (docs/DESIGN.md, "Adding a feature"). Private to core/terrain.
//
// A feature is a section of world.toml. It takes part in any of five stages, by the functions it overrides:
//   strata   make_deformation()  moves the strata of a column up or down
//   ground   survey()            looks at the ground around a region and keeps a number a column
//   air      make_carver()       carves air out of columns, and says where it opens to the sky
//   chunks   add_overlays()      puts material into a chunk's voxels
//   objects  place()             stands on the ground of a region, and add_overrides() gives its voxels
// Everything that it does is a pure function of the world and of positions: whatever region, chunk or thread
// computes them, the voxels are the same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <talus/terrain/cave_air.h>
#include <talus/terrain/field.h>
#include <talus/terrain/stacks.h>
#include <talus/terrain/world.h>
#include <talus/vectors/instruction_set.h>
#include <talus/voxel/coords.h>
#include <talus/voxel/material.h>

#include "overlay.h"
#include "place/place_fields.h"
#include "spec/places_section.h"
#include "spec/table_reader.h"

namespace talus::terrain {

/// Moves strata. Keeps its memory from region to region. For one thread at a time.
class Deformation {
 public:
  virtual ~Deformation() = default;
  /// Adds the lift in subvoxels of level 0 at all (x, z) of two ascending lists of base columns; `lift_fx`
  /// has their size. A pure function of the column: no halo.
  virtual void add(std::span<const std::int64_t> xs, std::span<const std::int64_t> zs, Field& lift_fx) = 0;
};

/// Carves one interval of air into columns. Keeps its memory from region to region. For one thread at a time.
class Carver {
 public:
  virtual ~Carver() = default;

  /// Columns around a column that decide whether it opens to the sky. 0 where a level has no air.
  [[nodiscard]] virtual int entrance_halo(Lod lod) const = 0;

  /// `height` is level 0's H over region.expanded(around), and exact there. Entrances are found over
  /// region.expanded(open_ring), REQUIRES around >= open_ring + entrance_halo(). The air over the region is
  /// exact where around >= Feature::halo(); with less it may differ.
  void compute(const Region& region, int around, int open_ring, const Field& height) {
    start(region, around, open_ring);
    while (pending()) compute_rows(region.depth + 2 * around, height);
  }
  /// The same in pieces; `height` is that of the whole region for each of them.
  virtual void start(const Region& region, int around, int open_ring) = 0;
  [[nodiscard]] virtual bool pending() const = 0;
  /// About `count` rows, or what takes as long. REQUIRES pending() and count > 0.
  virtual void compute_rows(int count, const Field& height) = 0;

  /// Where a column is open to the sky: the ground there, in subvoxels of the level, over
  /// region.expanded(open_ring); kClosed elsewhere. Empty where all are closed.
  [[nodiscard]] virtual const Field& entrances() const = 0;
  static constexpr std::int32_t kClosed = std::numeric_limits<std::int32_t>::min();

  /// The air over the region.
  virtual void take(CaveAir& air) const = 0;
};

/// A chunk whose stacks are voxels already, for features that put material into it. Valid during the call.
class ChunkSite {
 public:
  virtual ~ChunkSite() = default;

  [[nodiscard]] const World& world() const { return world_; }
  /// Of a region that holds the chunk.
  [[nodiscard]] const Stacks& stacks() const { return stacks_; }
  [[nodiscard]] ChunkKey key() const { return key_; }
  /// Columns from the corner of the stacks' region to that of the chunk.
  [[nodiscard]] int x() const { return x_; }
  [[nodiscard]] int z() const { return z_; }

  /// The rows of the chunk at which a field over the stacks lies: the first whose centre is not below it.
  virtual void cut(const Field& field, ChunkPlane& rows) const = 0;
  /// The rows at which rock ends, under loose material.
  [[nodiscard]] virtual const ChunkPlane& rock() const = 0;

 protected:
  ChunkSite(const World& world, const Stacks& stacks, ChunkCoord coord);

 private:
  const World& world_;
  const Stacks& stacks_;
  ChunkKey key_;
  int x_;
  int z_;
};

/// Rows of a level that a feature's overlays change.
struct OverlayRows {
  /// None below this row.
  std::int64_t lowest = std::numeric_limits<std::int64_t>::max();
  /// As many rows above the ground or the sea, whichever is higher.
  int above_ground = 0;
};

/// The ground of a region on which objects stand. Columns count from the region's corner; those of
/// Feature::halo() around it are known, too.
struct StandingGround {
  Region region;
  int around = 0;                       // columns around the region that `height` and `places` have
  const Field* height = nullptr;        // level 0's subvoxels
  const PlaceFields* places = nullptr;  // or null where the world has no shares
  const Field* entrances = nullptr;     // Carver::entrances(), or null
  int open_ring = 0;                    // columns around the region that those have
  std::optional<std::int32_t> sea_fx;

  [[nodiscard]] std::int32_t height_fx(int x, int z) const { return height->at(x + around, z + around); }
  [[nodiscard]] bool none(const std::optional<std::size_t>& rule) const {
    return rule && !places->has_share(*rule);
  }
  /// Of kWholeShare. REQUIRES !none(rule).
  [[nodiscard]] std::int32_t share(const std::optional<std::size_t>& rule, int x, int z) const {
    return rule ? places->share_at(*rule, x + around, z + around) : kWholeShare;
  }
  /// Whether there is dry ground, or any where water may be, and no cave opens.
  [[nodiscard]] bool carries(int x, int z, bool in_water) const {
    if (entrances != nullptr && entrances->at(x + open_ring, z + open_ring) != Carver::kClosed) return false;
    return in_water || !sea_fx || height_fx(x, z) >= *sea_fx;
  }
};

/// How far the objects of a region are placed.
struct Placement {
  std::size_t kind = 0;               // whose turn it is
  std::int64_t row = 0;               // of its cells, or of the region's columns
  std::vector<std::uint8_t> seen_in;  // how many objects a column shows, where each looks for its own
};

/// A feature of one world. Immutable; threads may share it.
class Feature {
 public:
  virtual ~Feature() = default;

  /// Where its lines stand in the canonical form: after the strata's, or after those of loose material.
  enum class Stage : std::uint8_t { strata, voxels };
  [[nodiscard]] virtual Stage stage() const { return Stage::voxels; }

  /// Writes everything that decides a voxel as lines of text, in the numbers that it is computed with, so
  /// that equal voxels have equal text. Names and colours are not written. It must not change for a world
  /// that is in use: the fingerprint is its hash.
  virtual void write_canonical_form(std::ostream& form) const = 0;

  /// Columns of H around a region that its survey and its carver read at a level.
  [[nodiscard]] virtual int halo(Lod /*lod*/) const { return 0; }

  /// No column's strata are lifted or sunk farther than `q16`, in 2^-16 terrain unit. The rest is for the
  /// error where all lifts and the surface's amplitude come to too many voxels.
  struct MaxLift {
    std::int64_t q16 = 0;
    std::string terms;  // of the sum, as "half of every throw"; empty where the feature moves no strata
    std::string key;    // "faults[0].throw": the one that adds most
    int line = 0;       // of that key
  };
  [[nodiscard]] virtual MaxLift max_lift() const { return {}; }
  [[nodiscard]] virtual std::unique_ptr<Deformation> make_deformation(InstructionSet /*set*/) const {
    return nullptr;
  }

  /// At most one feature of a world may carve: a column has one interval of air.
  [[nodiscard]] virtual bool carves() const { return false; }
  /// `world` must outlive the carver. REQUIRES carves().
  [[nodiscard]] virtual std::unique_ptr<Carver> make_carver(const World& /*world*/,
                                                            InstructionSet /*set*/) const {
    return nullptr;
  }

  /// Whether survey() is called and its result kept in Stacks::surveys.
  [[nodiscard]] virtual bool surveys() const { return false; }
  /// What the feature wants to know of each column of `region` when chunks are cut, into `survey` of the
  /// region's size. `height` is level 0's H over region.expanded(around); exact where around >= halo().
  virtual void survey(const Region& /*region*/, int /*around*/, const Field& /*height*/,
                      Field& /*survey*/) const {}

  [[nodiscard]] virtual OverlayRows overlay_rows(Lod /*lod*/) const { return {}; }
  /// Adds what becomes another material in a chunk, in the order in which it is applied; features are asked
  /// in the order of their list. `survey` is that of the site's stacks, or null.
  virtual void add_overlays(const ChunkSite& /*site*/, const Field* /*survey*/,
                            std::vector<Overlay>& /*overlays*/) const {}
  /// Whether place() is called and its objects are kept in Stacks::objects. At most one feature stands.
  [[nodiscard]] virtual bool stands() const { return false; }
  [[nodiscard]] virtual std::vector<ObjectKindName> object_kinds() const { return {}; }
  /// One piece of the work, which begins with Placement{}: about what `columns` columns of ground take, a row
  /// at least. False when nothing is left. REQUIRES columns > 0.
  virtual bool place(const StandingGround& /*ground*/, int /*columns*/, Placement& /*at*/,
                     std::vector<PlacedObject>& /*objects*/) const {
    return false;
  }
  /// The voxels of Stacks::objects in a chunk, by rising index, each once.
  virtual void add_overrides(const ChunkSite& /*site*/, std::vector<Override>& /*overrides*/) const {}
  /// What they show from above: of the columns of the stacks' region that they cover, where the topmost voxel
  /// ends, if that is not under `rows`, and its material.
  virtual void add_tops(const Stacks& /*stacks*/, std::span<MaterialId> /*materials*/,
                        std::span<std::int32_t> /*rows*/) const {}
  /// What it puts at the top of the rock of each column of the stacks' region, at the topmost voxel of bare
  /// ground, for maps; other columns stay as they are. z slowest, then x.
  virtual void add_exposed(const Stacks& /*stacks*/, const Field* /*survey*/,
                           std::span<MaterialId> /*exposed*/) const {}
};

/// A feature's section as it is read. spec() holds everything but features, read and checked.
class FeatureSection {
 public:
  FeatureSection(TableReader& root, std::string_view name, const WorldSpec& spec,
                 std::set<std::string>& names, std::vector<Material>& materials, PlacesReader& places,
                 const WorldFiles& files, std::span<const std::string> look_names)
      : root_{root},
        name_{name},
        spec_{spec},
        names_{names},
        materials_{materials},
        places_{places},
        files_{files},
        look_names_{look_names} {}

  [[nodiscard]] const WorldSpec& spec() const { return spec_; }
  /// [name]; none where the key is no table, which is an error.
  [[nodiscard]] std::optional<TableReader> table() { return root_.table(name_); }
  /// All [[name]].
  [[nodiscard]] std::vector<TableReader> tables() { return root_.tables(name_); }

  /// Reads `name` and `colour` of a table as a new material of the world. Ids go up in the order of calls.
  MaterialId add_material(TableReader& table, MaterialKind kind);
  /// One that the world has already, of any kind but air and water.
  [[nodiscard]] std::optional<MaterialId> material_named(std::string_view name) const;
  /// For `where` and looks of the section's tables.
  [[nodiscard]] PlacesReader& places() const { return places_; }
  /// What the spec may name.
  [[nodiscard]] const WorldFiles& files() const { return files_; }
  /// World::look_names(); empty for kinds that are read before looks.
  [[nodiscard]] std::span<const std::string> look_names() const { return look_names_; }

 private:
  TableReader& root_;
  std::string name_;
  const WorldSpec& spec_;
  std::set<std::string>& names_;
  std::vector<Material>& materials_;
  PlacesReader& places_;
  const WorldFiles& files_;
  std::span<const std::string> look_names_;
};

/// A kind of feature: what a section of world.toml becomes.
struct FeatureKind {
  /// The key of the section in world.toml.
  std::string_view section;
  /// Reads and checks the section, which is there. Faults go to its tables' fail(); what is returned after
  /// one is not used.
  std::unique_ptr<const Feature> (*read)(FeatureSection& section) = nullptr;
  /// Whether it asks for looks by name; its materials come after theirs.
  bool after_looks = false;
};

/// The kinds that ship with the library, as core/terrain/CMakeLists.txt lists them.
[[nodiscard]] std::span<const FeatureKind> shipped_features();

/// The one carver of a world, if it has any.
[[nodiscard]] std::unique_ptr<Carver> make_carver(const World& world, InstructionSet set);

}  // namespace talus::terrain
