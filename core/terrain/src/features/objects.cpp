#include "features/objects.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <string_view>

#include <talus/terrain/boundary_row.h>
#include <talus/terrain/lattice_hash.h>
#include <talus/toml/toml_error.h>

#include "place/places.h"
#include "spec/places_section.h"
#include "spec/units.h"
#include "surface/regions/regions.h"

namespace talus::terrain {
namespace {

constexpr std::size_t kMaxKinds = 32;
constexpr int kMinObjectSpacing = 4;
constexpr std::uint8_t kMaxSeen = 32;  // maximum number of objects shown by a column of level 3 to 6
constexpr std::size_t kMaxModelNameBytes = 200;
constexpr int kVariants = 32;        // shapes per formula; objects draw one of them and a quarter turn
constexpr double kMaxDensity = 256;  // object voxels per column, on average, if all kinds stand there
constexpr int kGap = 2;              // free margin of a cell, so that trunks in adjacent cells never touch
constexpr Lod kLastEnumerated = Lod::of(ModelLevels::kCoarsest);
constexpr double kClumpWavelength = 260;  // voxels
constexpr int kClumpOctaves = 3;
constexpr double kClumpGain = 0.6;

/// Rotates voxels by quarter turns about the foot.
struct Rotation {
  int cos;
  int sin;

  explicit Rotation(int turn)
      : cos{(turn & 1) != 0 ? 0 : 1 - (turn & 2)}, sin{(turn & 1) == 0 ? 0 : 2 - (turn & 3)} {}
  [[nodiscard]] int x(const ModelVoxel& voxel) const { return cos * voxel.x - sin * voxel.z; }
  [[nodiscard]] int z(const ModelVoxel& voxel) const { return sin * voxel.x + cos * voxel.z; }
};

float clump_share(Clumps clumps, float n) {
  if (clumps == Clumps::woods) return std::clamp(0.55F + 2.2F * n, 0.02F, 1.0F);
  return std::clamp(6 * std::clamp(n / 0.35F, 0.0F, 1.0F) + 0.25F, 0.0F, 1.0F);
}

std::uint64_t model_hash(const ObjectModel& model) {
  std::uint64_t hash = 0;
  for (const ModelVoxel& v : model) {
    const auto word = static_cast<std::uint64_t>(static_cast<std::uint8_t>(v.x)) |
                      static_cast<std::uint64_t>(static_cast<std::uint8_t>(v.y)) << 8 |
                      static_cast<std::uint64_t>(static_cast<std::uint8_t>(v.z)) << 16 |
                      static_cast<std::uint64_t>(v.part) << 24;
    hash = mix64(hash ^ word) + word;
  }
  return hash;
}

}  // namespace

struct Objects::Candidate {
  std::size_t kind = 0;
  std::int64_t x = 0;
  std::int64_t z = 0;
  std::uint64_t hash = 0;

  [[nodiscard]] std::int32_t draw_q16() const { return static_cast<std::int32_t>(hash >> 32 & 0xFFFF); }
  [[nodiscard]] PlacedObject at(std::int64_t y, std::size_t models) const {
    return {static_cast<std::uint16_t>(kind),
            static_cast<std::uint8_t>((hash >> 50 & 0xFF) % models),
            static_cast<std::uint8_t>(hash >> 48 & 3),
            x,
            y,
            z,
            hash};
  }
};

void Objects::write_canonical_form(TextWriter& form) const {
  for (const ObjectKind& kind : kinds_) {
    form << "object seed " << kind.seed << " spacing " << kind.spacing << " chance_q16 " << kind.chance_q16
         << " clumps " << static_cast<int>(kind.clumps) << " in_water " << (kind.in_water ? 1 : 0);
    if (kind.share) form << " share " << *kind.share;
    std::array<bool, 256> used{};
    for (const ObjectModel& model : kind.models) {
      form << " model " << model_hash(model);
      for (const ModelVoxel& voxel : model) used[voxel.part] = true;
    }
    for (std::size_t part = 0; part < used.size(); ++part) {
      if (used[part]) form << " part " << part << ' ' << to_integer(kind.parts[part]);
    }
    form << '\n';
  }
}

std::vector<ObjectKindName> Objects::object_kinds() const {
  std::vector<ObjectKindName> names;
  for (const ObjectKind& kind : kinds_) names.push_back({kind.name, kind.model});
  return names;
}

int Objects::halo(Lod lod) const {
  if (lod.value() > kLastEnumerated.value()) return 0;
  int reach = 0;
  for (const ObjectKind& kind : kinds_) reach = std::max(reach, kind.reach);
  const int step = 1 << lod.value();
  return (reach + step - 1) / step;
}

OverlayRows Objects::overlay_rows(Lod lod) const {
  int top = 0;
  for (const ObjectKind& kind : kinds_) top = std::max(top, kind.top);
  OverlayRows rows;
  rows.above_ground = (top >> lod.value()) + 1;
  return rows;
}

/// A cell's coordinate along x, with its half of the hash, which all cells of that x share.
struct Objects::CellX {
  CellX(const ObjectKind& kind, std::int64_t cell)
      : at{cell}, key{mix64(axis_key(kind.seed, Axis::x, cell))} {}
  std::int64_t at;
  std::uint64_t key;
};

/// The candidate of a cell; nullopt if its own draw excludes it everywhere.
std::optional<Objects::Candidate> Objects::candidate(std::size_t kind, const CellX& cell_x,
                                                     std::int64_t cell_z) const {
  const ObjectKind& of = kinds_[kind];
  const std::uint64_t hash = mix64(cell_x.key ^ std::rotl(axis_key(of.seed, Axis::z, cell_z), 32));
  Candidate candidate{kind, 0, 0, hash};
  if (candidate.draw_q16() >= of.chance_q16) return std::nullopt;
  const std::int64_t room = of.spacing - kGap;
  candidate.x = cell_x.at * of.spacing +
                static_cast<std::int64_t>((hash & 0xFFFF) * static_cast<std::uint64_t>(room) >> 16);
  candidate.z = cell_z * of.spacing +
                static_cast<std::int64_t>((hash >> 16 & 0xFFFF) * static_cast<std::uint64_t>(room) >> 16);
  return candidate;
}

/// Returns true if the candidate stands at a place where its kind has `share` of kWholeShare.
bool Objects::present(const Candidate& candidate, std::int32_t share) const {
  const ObjectKind& kind = kinds_[candidate.kind];
  const auto limit_q16 = static_cast<std::int32_t>(std::int64_t{kind.chance_q16} * share / kWholeShare);
  if (candidate.draw_q16() >= limit_q16) return false;
  if (kind.clumps == Clumps::none) return true;
  const float n = clumps_.at(candidate.x, candidate.z);
  const auto clump = static_cast<std::int32_t>(clump_share(kind.clumps, n) * static_cast<float>(kWholeShare));
  return candidate.draw_q16() < static_cast<std::int32_t>(std::int64_t{limit_q16} * clump / kWholeShare);
}

bool Objects::place(const StandingGround& ground, int columns, Placement& at,
                    std::vector<PlacedObject>& objects) const {
  const Region& region = ground.region;
  const auto absent = [&](const ObjectKind& kind) {
    return ground.none(kind.share) || region.lod.value() >= kind.levels_shown;
  };
  while (at.kind < kinds_.size() && absent(kinds_[at.kind])) ++at.kind;
  if (at.kind == kinds_.size()) return false;
  const bool in_cells = region.lod.value() <= kLastEnumerated.value();
  if (!in_cells && at.seen_in.size() != region.columns()) at.seen_in.assign(region.columns(), 0);
  // A candidate costs as much as some columns of ground, and a column reads the candidates of some cells.
  constexpr std::int64_t kColumnsACandidate = 8;
  const std::int64_t spacing = kinds_[at.kind].spacing;
  const std::int64_t a_row =
      in_cells ? ((std::int64_t{region.width} << region.lod.value()) + 2 * kinds_[at.kind].reach) / spacing
               : 4 * std::int64_t{region.width};
  const std::int64_t rows =
      std::max<std::int64_t>(1, columns / kColumnsACandidate / std::max<std::int64_t>(1, a_row));
  if (in_cells ? place_in_cells(ground, rows, at, objects) : place_by_columns(ground, rows, at, objects)) {
    return true;
  }
  ++at.kind;
  at.row = 0;
  return at.kind < kinds_.size();
}

// An object stands on the ground of the level's column that contains its foot.
bool Objects::place_in_cells(const StandingGround& ground, std::int64_t rows, Placement& at,
                             std::vector<PlacedObject>& objects) const {
  const ObjectKind& of = kinds_[at.kind];
  const int level = ground.region.lod.value();
  const Region around = ground.region.expanded(halo(ground.region.lod));
  const std::int64_t west = around.x << level;
  const std::int64_t north = around.z << level;
  const std::int64_t east = (around.x + around.width) << level;
  const std::int64_t south = (around.z + around.depth) << level;
  std::int64_t cz = floor_div(north, of.spacing) + at.row;
  at.row += rows;
  for (; rows > 0 && cz * of.spacing < south; ++cz, --rows) {
    for (std::int64_t cx = floor_div(west, of.spacing); cx * of.spacing < east; ++cx) {
      const auto found = candidate(at.kind, {of, cx}, cz);
      if (!found || found->x < west || found->x >= east || found->z < north || found->z >= south) continue;
      const int x = static_cast<int>((found->x >> level) - ground.region.x);
      const int z = static_cast<int>((found->z >> level) - ground.region.z);
      if (!ground.carries(x, z, of.in_water) || !present(*found, ground.share(of.share, x, z))) continue;
      objects.push_back(found->at(boundary_row(ground.height_fx(x, z)), of.models.size()));
    }
  }
  return cz * of.spacing < south;
}

/// The voxels of its model in the one column that shows it.
std::span<const ModelVoxel> Objects::seen(const PlacedObject& object) const {
  const ModelVoxel column{static_cast<std::int8_t>(object.seen_x - object.x), 0,
                          static_cast<std::int8_t>(object.seen_z - object.z)};
  const Rotation back{4 - object.turn};
  return kinds_[object.kind].columns[object.variant].at(back.x(column), back.z(column));
}

// A coarse column shows one base column. Columns lie so far apart that enumerating all objects between them
// would cost too much: each column searches only for objects that reach it, and uses its own ground as
// theirs. A column shows at most kMaxSeen objects, earlier kinds first, to bound the memory of dense woods.
bool Objects::place_by_columns(const StandingGround& ground, std::int64_t rows, Placement& at,
                               std::vector<PlacedObject>& objects) const {
  const ObjectKind& of = kinds_[at.kind];
  const int level = ground.region.lod.value();
  const auto last = static_cast<int>(std::min<std::int64_t>(at.row + rows, ground.region.depth));
  std::vector<CellX> cells;
  for (auto z = static_cast<int>(at.row); z < last; ++z) {
    if (ground.none_along(of.share, z)) continue;
    for (int x = 0; x < ground.region.width; ++x) {
      const std::int32_t share = ground.share(of.share, x, z);
      if (share == 0 || !ground.carries(x, z, of.in_water)) continue;
      std::uint8_t& shown =
          at.seen_in[static_cast<std::size_t>(z) * static_cast<std::size_t>(ground.region.width) +
                     static_cast<std::size_t>(x)];
      const std::int64_t base_x = (ground.region.x + x) << level;
      const std::int64_t base_z = (ground.region.z + z) << level;
      cells.clear();
      for (std::int64_t cx = floor_div(base_x - of.reach, of.spacing); cx * of.spacing <= base_x + of.reach;
           ++cx) {
        cells.emplace_back(of, cx);
      }
      for (std::int64_t cz = floor_div(base_z - of.reach, of.spacing); cz * of.spacing <= base_z + of.reach;
           ++cz) {
        for (const CellX& cell : cells) {
          const auto found = candidate(at.kind, cell, cz);
          if (!found || std::abs(found->x - base_x) > of.reach || std::abs(found->z - base_z) > of.reach)
            continue;
          PlacedObject object = found->at(boundary_row(ground.height_fx(x, z)), of.models.size());
          object.seen_x = base_x;
          object.seen_z = base_z;
          if (shown == kMaxSeen || seen(object).empty() || !present(*found, share)) continue;
          ++shown;
          objects.push_back(object);
        }
      }
    }
  }
  at.row = last;
  return last < ground.region.depth;
}

// Voxel (x, y, z) of level l shows base voxel (x << l, (y << l) + half of a voxel, z << l).
template <class Visit>
void Objects::for_each_voxel(const PlacedObject& object, Lod lod, bool front, const VoxelPos& origin,
                             std::optional<int> height, const Visit& visit) const {
  const ObjectKind& kind = kinds_[object.kind];
  const int level = lod.value();
  const std::int64_t half = level == 0 ? 0 : std::int64_t{1} << (level - 1);
  const int mask = (1 << level) - 1;
  const Rotation turn{object.turn};
  const auto foot_x = static_cast<int>(object.x - (origin.x << level));
  const auto foot_y = static_cast<int>(object.y - half - (origin.y << level));
  const auto foot_z = static_cast<int>(object.z - (origin.z << level));
  const auto visit_shown = [&](std::span<const ModelVoxel> voxels) {
    for (const ModelVoxel& voxel : voxels) {
      if ((voxel.part == 0) != front) continue;
      const int x = foot_x + turn.x(voxel);
      const int y = foot_y + voxel.y;
      const int z = foot_z + turn.z(voxel);
      if (((x | y | z) & mask) != 0) continue;
      visit(x >> level, y >> level, z >> level, kind.parts[voxel.part]);
    }
  };
  if (level > kLastEnumerated.value()) return visit_shown(seen(object));
  if (level == 0) {
    const ModelRows& rows = kind.rows[object.variant];
    return visit_shown(height ? rows.at(front, -foot_y, *height - foot_y)
                              : rows.at(front, -kObjectRoot, kObjectTop));
  }
  // The foot modulo the level's step, in the model's orientation: such voxels lie on the level's planes.
  const ModelVoxel low{static_cast<std::int8_t>(-foot_x & mask), 0, static_cast<std::int8_t>(-foot_z & mask)};
  const Rotation back{4 - object.turn};
  visit_shown(kind.levels[object.variant].at(front, level, back.x(low), -foot_y, back.z(low)));
}

namespace {

/// The new materials of a chunk's voxels.
class ChangedVoxels {
 public:
  /// If `changes` is false, writes to a dummy element: the branch would be unpredictable.
  void set(bool changes, std::size_t voxel, MaterialId material) {
    const std::size_t at = changes ? voxel : kChunkVolume;
    materials_[at] = material;
    changed_[at / 64] |= std::uint64_t{1} << at % 64;
  }
  void add_to(std::vector<Override>& overrides) const {
    for (std::size_t word = 0; word < kWords; ++word) {
      for (std::uint64_t bits = changed_[word]; bits != 0; bits &= bits - 1) {
        const auto voxel = word * 64 + static_cast<std::size_t>(std::countr_zero(bits));
        overrides.push_back({static_cast<std::uint16_t>(voxel), materials_[voxel]});
      }
    }
  }

 private:
  static constexpr std::size_t kWords = kChunkVolume / 64;
  std::array<MaterialId, kChunkVolume + 1> materials_;  // valid if the voxel's bit is set
  std::array<std::uint64_t, kWords + 1> changed_{};
};

/// The lowest rows of a chunk in which objects may have voxels.
struct ObjectFloors {
  ChunkPlane in_water;
  ChunkPlane dry;
};

ObjectFloors floors_of(const ChunkSite& site) {
  ObjectFloors floors;
  const Stacks& stacks = site.stacks();
  site.cut(stacks.tops.back(), floors.in_water);
  floors.dry = floors.in_water;
  const auto sea_fx = site.world().sea_fx();
  if (!sea_fx) return floors;
  const std::int64_t above =
      boundary_row(*sea_fx >> site.key().lod.value()) - chunk_origin(site.key().coord).y;
  const auto sea = static_cast<std::uint8_t>(std::clamp<std::int64_t>(above, 0, kChunkSize));
  for (int z = 0; sea > 0 && z < kChunkSize; ++z) {
    for (int x = 0; x < kChunkSize; ++x) {
      std::uint8_t& floor = floors.dry[column_index(x, z)];
      if (floor < sea && !stacks.is_entrance(site.x() + x, site.z() + z)) floor = sea;
    }
  }
  return floors;
}

}  // namespace

bool Objects::places(MaterialId material) const {
  return std::any_of(kinds_.begin(), kinds_.end(), [&](const ObjectKind& kind) {
    return std::find(kind.parts.begin(), kind.parts.end(), material) != kind.parts.end();
  });
}

void Objects::add_overrides(const ChunkSite& site, std::vector<Override>& overrides) const {
  const Stacks& stacks = site.stacks();
  if (stacks.objects.empty()) return;
  const Lod lod = site.key().lod;
  const int level = lod.value();
  const VoxelPos origin = chunk_origin(site.key().coord);
  const auto reaches = [&](const PlacedObject& object) {
    const ObjectKind& kind = kinds_[object.kind];
    const auto apart = [&](std::int64_t middle, std::int64_t below, std::int64_t above, std::int64_t from) {
      return middle + above < from << level || middle - below >= (from + kChunkSize) << level;
    };
    // Most chunks lie below all objects.
    return !apart(object.y, kObjectRoot, kObjectTop, origin.y) &&
           !apart(object.y, kObjectRoot, kind.top, origin.y) &&
           !apart(object.x, kind.reach, kind.reach, origin.x) &&
           !apart(object.z, kind.reach, kind.reach, origin.z);
  };
  std::vector<PlacedObject> near;
  std::copy_if(stacks.objects.rbegin(), stacks.objects.rend(), std::back_inserter(near), reaches);
  if (near.empty()) return;
  const ObjectFloors floors = floors_of(site);
  const auto changed = std::make_unique_for_overwrite<ChangedVoxels>();
  // From back to front, as later writes win: first crowns, then stems, each from the last kind to the first.
  for (const bool front : {false, true}) {
    for (const PlacedObject& object : near) {
      const ChunkPlane& floor = kinds_[object.kind].in_water ? floors.in_water : floors.dry;
      for_each_voxel(object, lod, front, origin, kChunkSize, [&](int x, int y, int z, MaterialId material) {
        const auto column = static_cast<std::size_t>(z * kChunkSize + x) % kChunkArea;
        const bool inside = ((x | y | z) & ~(kChunkSize - 1)) == 0;
        changed->set(inside & (y >= floor[column]), static_cast<std::size_t>(y) * kChunkArea + column,
                     material);
      });
    }
  }
  changed->add_to(overrides);
}

void Objects::add_tops(const Stacks& stacks, std::span<MaterialId> materials,
                       std::span<std::int32_t> rows) const {
  const Region& region = stacks.region;
  // As in add_overrides(), later writes are in front.
  for (const bool front : {false, true}) {
    for (auto object = stacks.objects.rbegin(); object != stacks.objects.rend(); ++object) {
      const bool in_water = kinds_[object->kind].in_water;
      for_each_voxel(*object, region.lod, front, {region.x, 0, region.z}, std::nullopt,
                     [&](int x, int y, int z, MaterialId material) {
                       if (x < 0 || z < 0 || x >= region.width || z >= region.depth) return;
                       const auto i = static_cast<std::size_t>(z * region.width + x);
                       if (y < boundary_row(stacks.tops.back().values[i]) || y + 1 < rows[i]) return;
                       // Without an object, the row is the sea's topmost.
                       if (y + 1 == rows[i] && materials[i] == kAir && !in_water) return;
                       materials[i] = material;
                       rows[i] = y + 1;
                     });
    }
  }
}

namespace {

class ObjectReader {
 public:
  explicit ObjectReader(FeatureSection& section) : section_{section} {}

  std::unique_ptr<const Feature> read() {
    std::vector<TableReader> tables = section_.tables();
    const WorldSpec& spec = section_.spec();
    if (spec.method == Method::erosion && !tables.empty()) {
      tables.front().fail("name",
                          "objects stand on ground that stays; leave them out, or method = \"erosion\"");
    }
    std::vector<ObjectKind> kinds;
    for (TableReader& table : tables) {
      if (kinds.size() == kMaxKinds) {
        table.fail("name", text_of("more than ", kMaxKinds, " kinds of objects; leave some out"));
        break;
      }
      kinds.push_back(read_kind(table, kinds));
      check_density(table, kinds.back());
    }
    const std::uint64_t seed = named_seed(spec.seed, ".clumps");
    const RotatedNoise clumps{seed, rounded(kClumpWavelength), kClumpOctaves, kClumpGain,
                              static_cast<int>(seed % kLatticeAngles)};
    return std::make_unique<Objects>(std::move(kinds), clumps);
  }

 private:
  ObjectKind read_kind(TableReader& table, const std::vector<ObjectKind>& others) {
    ObjectKind kind;
    kind.name = table.text("name", kMaxNameBytes);
    const bool known = std::any_of(others.begin(), others.end(),
                                   [&](const ObjectKind& other) { return other.name == kind.name; });
    if (known) table.fail("name", "'" + kind.name + "' names another object already; names are unique");
    kind.seed = named_seed(section_.spec().seed, ".object " + kind.name);
    read_models(table, kind);
    // Bounds the number of an author's models, which may be full, that reach any one column.
    const int closest = is_file(kind) ? std::max(kMinObjectSpacing, kind.reach) : kMinObjectSpacing;
    kind.spacing = static_cast<int>(table.integer("spacing", closest, 64));
    kind.chance_q16 = static_cast<std::int32_t>(rounded(table.real("chance", {0, 1}) * 65536));
    if (table.has("clumps"))
      kind.clumps = table.choice("clumps", {"woods", "groves"}) == 0 ? Clumps::woods : Clumps::groves;
    kind.in_water = table.has("in_water") && table.boolean("in_water");
    kind.share = section_.places().share(table, section_.look_names());
    return kind;
  }

  // Bounds the time of a chunk.
  void check_density(TableReader& table, const ObjectKind& kind) {
    if (kind.models.empty() || kind.spacing == 0) return;
    std::size_t voxels = 0;
    for (const ObjectModel& model : kind.models) voxels += model.size();
    const double mean = static_cast<double>(voxels) / static_cast<double>(kind.models.size());
    density_ += mean * kind.chance_q16 / 65536 / kind.spacing / kind.spacing;
    if (density_ <= kMaxDensity) return;
    table.fail(
        "spacing",
        text_of("with this kind ", std::ceil(density_),
                " voxels of objects (voxels of a model * chance / spacing^2) stand on a column; at most ",
                kMaxDensity, ", so space some kinds wider"));
    density_ = 0;
  }

  static bool is_file(const ObjectKind& kind) {
    constexpr std::string_view kSuffix = ".vox";
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    return kind.model.size() >= kSuffix.size() &&
           std::equal(kSuffix.rbegin(), kSuffix.rend(), kind.model.rbegin(),
                      [&](char wanted, char c) { return wanted == lower(c); });
  }

  void read_models(TableReader& table, ObjectKind& kind) {
    kind.model = table.text("model", kMaxModelNameBytes);
    is_file(kind) ? read_file(table, kind) : read_formula(table, kind);
    kind.levels_shown = levels_shown(kind.models);
    for (const ObjectModel& model : kind.models) {
      kind.columns.emplace_back(model);
      kind.rows.emplace_back(model);
      kind.levels.emplace_back(model);
      for (const ModelVoxel& voxel : model) {
        kind.reach = std::max({kind.reach, std::abs(int{voxel.x}), std::abs(int{voxel.z})});
        kind.top = std::max(kind.top, voxel.y + 1);
      }
    }
  }

  static void allow(TableReader& table, std::span<const std::string_view> parts) {
    std::vector<std::string_view> keys{"name",  "model", "spacing", "chance",
                                       "looks", "where", "clumps",  "in_water"};
    std::copy_if(parts.begin(), parts.end(), std::back_inserter(keys),
                 [](std::string_view part) { return !part.empty(); });
    table.only(keys);
  }

  void read_formula(TableReader& table, ObjectKind& kind) {
    const auto number = static_cast<std::size_t>(std::distance(
        kModelForms.begin(), std::find_if(kModelForms.begin(), kModelForms.end(),
                                          [&](const ModelForm& each) { return each.name == kind.model; })));
    if (number == kModelForms.size()) {
      std::string names;
      for (const ModelForm& each : kModelForms) names += std::string{each.name} + ", ";
      table.fail("model", "'" + shortened(kind.model, kMaxModelNameBytes) + "' is not a model; " + names +
                              "or the name of a .vox file is needed");
      return;
    }
    const auto& parts = kModelForms[number].parts;
    allow(table, parts);
    for (std::size_t part = 0; part < parts.size(); ++part) {
      if (parts[part].empty()) continue;
      kind.parts[part] = read_part(table, std::string{parts[part]});
    }
    for (int variant = 0; variant < kVariants; ++variant) {
      kind.models.push_back(make_model(static_cast<ModelKind>(number),
                                       derived_seed(kind.seed, static_cast<std::uint64_t>(variant))));
    }
  }

  /// Reads a .vox file; its palette's entries are parts, the lowest number in front.
  void read_file(TableReader& table, ObjectKind& kind) {
    const auto refuse = [&](const std::string& why) {
      table.fail("model", "'" + shortened(kind.model, kMaxModelNameBytes) + "': " + why);
    };
    allow(table, std::array<std::string_view, 1>{"palette"});
    if (!section_.files().models) return refuse("models cannot be read here; give a spec without one");
    const auto [known, is_new] = files_.try_emplace(kind.model);
    if (is_new) known->second = section_.files().models(kind.model);
    const auto& models = known->second;
    if (!models) return refuse(models.error());
    std::array<bool, 256> used{};
    for (const VoxelModel& model : *models) {
      if (model.voxels.empty()) return refuse("a model without voxels");
      for (const VoxelModel::Voxel& voxel : model.voxels) used[voxel.colour] = true;
    }
    auto palette = table.table("palette");
    if (!palette) return;
    std::vector<std::string> numbers;
    std::array<std::uint8_t, 256> part_of{};
    for (std::size_t colour = 0; colour < used.size(); ++colour) {
      if (!used[colour]) continue;
      part_of[colour] = static_cast<std::uint8_t>(numbers.size());
      const std::string number = numbers.emplace_back(std::to_string(colour));
      if (palette->has(number)) {
        kind.parts[part_of[colour]] = read_part(*palette, number);
      } else {
        palette->fail(number, "is a colour of '" + shortened(kind.model, kMaxModelNameBytes) +
                                  "' without a material; { name = \"...\" } is needed");
      }
    }
    palette->only({numbers.begin(), numbers.end()});
    for (const VoxelModel& model : *models) kind.models.push_back(model_of(model, part_of));
  }

  /// Returns a new material with a colour, or an existing one.
  MaterialId read_part(TableReader& table, const std::string& key) {
    auto part = table.table(key);
    if (!part) return kAir;
    part->only({"name", "colour"});
    if (part->has("colour")) return section_.add_material(*part, MaterialKind::stratified);
    const std::string name = part->text("name", kMaxNameBytes);
    const auto material = section_.material_named(name);
    if (!material) {
      part->fail("name", "no material is named '" + name + "'; give it a colour to make a new one");
      return kAir;
    }
    return *material;
  }

  FeatureSection& section_;
  std::map<std::string, tl::expected<std::vector<VoxelModel>, std::string>>
      files_;           // that were read, by name
  double density_ = 0;  // voxels per column of the kinds read so far
};

std::unique_ptr<const Feature> read_objects(FeatureSection& section) {
  return ObjectReader{section}.read();
}

}  // namespace

namespace features {

FeatureKind objects() {
  return {"object", read_objects, true};
}

}  // namespace features
}  // namespace talus::terrain
