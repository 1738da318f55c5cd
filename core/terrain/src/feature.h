// The interface of features: folds, faults, ores and caves each are one file in features/, and so is a new
// one (docs/DESIGN.md, "Adding a feature"). Private to core/terrain.
//
// A feature is a section of world.toml. It takes part in any of five stages, by overriding functions:
//   strata   make_deformation()  moves the strata of a column up or down
//   ground   survey()            reads the ground around a region and keeps a number per column
//   air      make_carver()       carves air out of columns and reports where it opens to the sky
//   chunks   add_overlays()      puts material into a chunk's voxels
//   objects  place()             puts objects on the ground of a region; add_overrides() gives their voxels
// Everything it computes is a pure function of the world and of positions: the voxels do not depend on the
// region, chunk or thread.
#pragma once

#include <cstddef>
#include <cstdint>
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
#include <talus/terrain/secret.h>
#include <talus/terrain/stacks.h>
#include <talus/terrain/world.h>
#include <talus/vectors/instruction_set.h>
#include <talus/voxel/coords.h>
#include <talus/voxel/material.h>

#include "features/sip_hash.h"
#include "overlay.h"
#include "place/place_fields.h"
#include "spec/places_section.h"
#include "spec/table_reader.h"
#include "spec/text_writer.h"

namespace talus::terrain {

/// Moves strata. Reuses its memory from region to region; not thread-safe.
class Deformation {
 public:
  virtual ~Deformation() = default;
  /// Adds the lift in subvoxels of level 0 at all (x, z) of two ascending lists of base columns; `lift_fx`
  /// has their size. A pure function of the column, so it needs no halo.
  virtual void add(std::span<const std::int64_t> xs, std::span<const std::int64_t> zs, Field& lift_fx) = 0;
};

/// Carves one interval of air into columns. Reuses its memory from region to region; not thread-safe.
class Carver {
 public:
  virtual ~Carver() = default;

  /// Columns around a column that decide whether it opens to the sky. 0 if a level has no air.
  [[nodiscard]] virtual int entrance_halo(Lod lod) const = 0;

  /// `height` is level 0's H over region.expanded(around), and exact there. Entrances are found over
  /// region.expanded(open_ring). The air over the region is exact if around >= Feature::halo(); otherwise it
  /// may differ. REQUIRES around >= open_ring + entrance_halo().
  void compute(const Region& region, int around, int open_ring, const Field& height) {
    start(region, around, open_ring);
    while (pending()) compute_rows(region.depth + 2 * around, height);
  }
  /// compute() in pieces; `height` is the whole region's in each piece.
  virtual void start(const Region& region, int around, int open_ring) = 0;
  [[nodiscard]] virtual bool pending() const = 0;
  /// Computes about `count` rows, or work of the same duration. REQUIRES pending() and count > 0.
  virtual void compute_rows(int count, const Field& height) = 0;

  /// The ground in columns that are open to the sky, in subvoxels of the level, over
  /// region.expanded(open_ring); kClosed in other columns. Empty if all are closed.
  [[nodiscard]] virtual const Field& entrances() const = 0;
  static constexpr std::int32_t kClosed = std::numeric_limits<std::int32_t>::min();

  /// The air over the region.
  virtual void take(CaveAir& air) const = 0;
};

/// A chunk whose stacks are already voxels, for features that put material into it. Valid during the call.
class ChunkSite {
 public:
  virtual ~ChunkSite() = default;

  [[nodiscard]] const World& world() const { return world_; }
  /// The stacks of a region that contains the chunk.
  [[nodiscard]] const Stacks& stacks() const { return stacks_; }
  [[nodiscard]] ChunkKey key() const { return key_; }
  /// Columns from the corner of the stacks' region to the corner of the chunk.
  [[nodiscard]] int x() const { return x_; }
  [[nodiscard]] int z() const { return z_; }

  /// The chunk's boundary rows of a field over the stacks: the first row whose centre is not below it.
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

/// The rows of a level that a feature's overlays may change.
struct OverlayRows {
  /// The lowest row.
  std::int64_t lowest = std::numeric_limits<std::int64_t>::max();
  /// Number of rows above the higher of ground and sea.
  int above_ground = 0;
};

/// The ground of a region on which objects stand. Columns count from the region's corner and extend
/// Feature::halo() columns around it.
struct StandingGround {
  Region region;
  int around = 0;                       // columns around the region in `height` and `places`
  const Field* height = nullptr;        // in level 0's subvoxels
  const PlaceFields* places = nullptr;  // null if the world has no shares
  const Field* entrances = nullptr;     // Carver::entrances(), or null
  int open_ring = 0;                    // columns around the region in `entrances`
  std::optional<std::int32_t> sea_fx;

  [[nodiscard]] std::int32_t height_fx(int x, int z) const { return height->at(x + around, z + around); }
  [[nodiscard]] bool none(const std::optional<std::size_t>& rule) const {
    return rule && !places->has_share(*rule);
  }
  /// Returns true if the share is known to be 0 along row z. REQUIRES !none(rule).
  [[nodiscard]] bool none_along(const std::optional<std::size_t>& rule, int z) const {
    return rule && places->is_none(*rule, z + around);
  }
  /// 0 to kWholeShare. REQUIRES !none(rule).
  [[nodiscard]] std::int32_t share(const std::optional<std::size_t>& rule, int x, int z) const {
    return rule ? places->share_at(*rule, x + around, z + around) : kWholeShare;
  }
  /// Returns true if the ground is dry, or water is allowed, and no cave opens.
  [[nodiscard]] bool carries(int x, int z, bool in_water) const {
    if (entrances != nullptr && entrances->at(x + open_ring, z + open_ring) != Carver::kClosed) return false;
    return in_water || !sea_fx || height_fx(x, z) >= *sea_fx;
  }
};

/// Progress of placing the objects of a region.
struct Placement {
  std::size_t kind = 0;               // next kind
  std::int64_t row = 0;               // next row of the kind's cells, or of the region's columns
  std::vector<std::uint8_t> seen_in;  // objects shown by each column, if columns search for their own
};

/// A feature of one world. Immutable; thread-safe.
class Feature {
 public:
  virtual ~Feature() = default;

  /// Position of its lines in the canonical form: after the strata's, or after the loose materials'.
  enum class Stage : std::uint8_t { strata, voxels };
  [[nodiscard]] virtual Stage stage() const { return Stage::voxels; }

  /// Writes everything that decides a voxel as lines of text, in the numbers used to compute it, so that
  /// equal voxels have equal text. Excludes names and colours. It must not change for a world that is in use:
  /// the fingerprint is its hash.
  virtual void write_canonical_form(TextWriter& form) const = 0;

  /// Columns of H around a region that its survey and its carver read at a level.
  [[nodiscard]] virtual int halo(Lod /*lod*/) const { return 0; }

  /// Maximum distance by which strata are lifted or sunk, in 2^-16 terrain unit. The other members are for
  /// the error that all lifts and the surface's amplitude sum to too many voxels.
  struct MaxLift {
    std::int64_t q16 = 0;
    std::string terms;  // of the sum, e.g. "half of every throw"; empty if the feature moves no strata
    std::string key;    // key of the largest term, e.g. "faults[0].throw"
    int line = 0;       // line of that key
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

  /// Returns true if survey() must be called and its result kept in Stacks::surveys.
  [[nodiscard]] virtual bool surveys() const { return false; }
  /// Writes to `survey`, of the region's size, the number per column that the feature needs when chunks are
  /// cut. `height` is level 0's H over region.expanded(around); exact if around >= halo().
  virtual void survey(const Region& /*region*/, int /*around*/, const Field& /*height*/,
                      Field& /*survey*/) const {}

  [[nodiscard]] virtual OverlayRows overlay_rows(Lod /*lod*/) const { return {}; }
  /// Adds the overlays of a chunk, in the order in which they apply. Features are called in the order of
  /// their list. `survey` covers the site's stacks, or is null.
  virtual void add_overlays(const ChunkSite& /*site*/, const Field* /*survey*/,
                            std::vector<Overlay>& /*overlays*/) const {}
  /// True if place() must be called and its objects kept in Stacks::objects. At most one feature stands.
  [[nodiscard]] virtual bool stands() const { return false; }
  [[nodiscard]] virtual std::vector<ObjectKindName> object_kinds() const { return {}; }
  /// Does one piece of the work, which starts from Placement{}: about as much as `columns` columns of ground,
  /// at least one row. False when nothing is left. REQUIRES columns > 0.
  virtual bool place(const StandingGround& /*ground*/, int /*columns*/, Placement& /*at*/,
                     std::vector<PlacedObject>& /*objects*/) const {
    return false;
  }
  /// True if voxels of its objects have the material.
  [[nodiscard]] virtual bool places(MaterialId /*material*/) const { return false; }
  /// Adds the voxels of Stacks::objects in a chunk, by ascending index, each once.
  virtual void add_overrides(const ChunkSite& /*site*/, std::vector<Override>& /*overrides*/) const {}
  /// Adds the objects as seen from above: in each column of the stacks' region that they cover, unless their
  /// topmost voxel ends below `rows`, sets its material and the row at which it ends.
  virtual void add_tops(const Stacks& /*stacks*/, std::span<MaterialId> /*materials*/,
                        std::span<std::int32_t> /*rows*/) const {}
  /// Sets the material that the feature puts at the topmost voxel of bare rock in columns of the stacks'
  /// region, for maps; other columns are unchanged. z slowest, then x.
  virtual void add_exposed(const Stacks& /*stacks*/, const Field* /*survey*/,
                           std::span<MaterialId> /*exposed*/) const {}

  /// The same feature, drawn by `draw` and shown by `view`; null if it cannot be secret.
  [[nodiscard]] virtual std::shared_ptr<const Feature> kept_secret(const SipHash& /*draw*/,
                                                                   SecretView /*view*/) const {
    return nullptr;
  }
  /// Writes the secret materials of a chunk of level 0 to `voxels`, as if all of it were rock. False if there
  /// are none.
  [[nodiscard]] virtual bool add_secret(ChunkCoord /*chunk*/,
                                        std::span<MaterialId, kChunkVolume> /*voxels*/) const {
    return false;
  }
};

/// A feature's section while it is read. spec() holds everything except features, read and checked.
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
  /// Returns [name]; nullopt, with an error, if the key is not a table.
  [[nodiscard]] std::optional<TableReader> table() { return root_.table(name_); }
  /// Returns all [[name]].
  [[nodiscard]] std::vector<TableReader> tables() { return root_.tables(name_); }

  /// Reads `name` and `colour` of a table as a new material of the world. Ids ascend in the order of calls.
  MaterialId add_material(TableReader& table, MaterialKind kind);
  /// Returns an existing material of any kind except air and water.
  [[nodiscard]] std::optional<MaterialId> material_named(std::string_view name) const;
  /// Reads `where` and looks of the section's tables.
  [[nodiscard]] PlacesReader& places() const { return places_; }
  /// Loaders of the files that the spec may name.
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

/// A kind of feature, read from one section of world.toml.
struct FeatureKind {
  /// The key of the section in world.toml.
  std::string_view section;
  /// Reads and checks the section, which exists. Reports errors through its tables' fail(); the result after
  /// an error is not used.
  std::unique_ptr<const Feature> (*read)(FeatureSection& section) = nullptr;
  /// True if it refers to looks by name; its materials then come after theirs.
  bool after_looks = false;
};

/// The kinds that ship with the library, as core/terrain/CMakeLists.txt lists them.
[[nodiscard]] std::span<const FeatureKind> shipped_features();

/// Makes the carver of a world; null if it has none.
[[nodiscard]] std::unique_ptr<Carver> make_carver(const World& world, InstructionSet set);

}  // namespace talus::terrain
