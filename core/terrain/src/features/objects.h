// [[object]]: trees, boulders and models that stand on the ground. Private to core/terrain.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "feature.h"
#include "features/object_models.h"
#include "noise/rotated_fbm.h"

namespace talus::terrain {

enum class Clumps : std::uint8_t { none, woods, groves };

/// Where objects of a kind stand: one candidate in each square cell of the endless plane.
struct ObjectKind {
  std::string name;
  std::string model;
  std::uint64_t seed = 0;
  int spacing = 0;              // base columns: the edge of a cell
  std::int32_t chance_q16 = 0;  // of a candidate
  Clumps clumps = Clumps::none;
  bool in_water = false;
  std::optional<std::size_t> share;     // of PlacesSpec::shares
  std::array<MaterialId, 256> parts{};  // by ModelVoxel::part
  std::vector<ObjectModel> models;      // a candidate draws one
  std::vector<ModelColumns> columns;    // of each model
  std::vector<ModelRows> rows;          // of each model
  std::vector<ModelLevels> levels;      // of each model
  int reach = 0;                        // of all models: columns from the foot
  int top = 0;                          // rows above the ground
  int levels_shown = 0;                 // level 0 among them; coarser ones leave the kind out
};

class Objects final : public Feature {
 public:
  Objects(std::vector<ObjectKind> kinds, RotatedNoise clumps) : kinds_{std::move(kinds)}, clumps_{clumps} {}

  void write_canonical_form(std::ostream& form) const override;
  [[nodiscard]] int halo(Lod lod) const override;
  [[nodiscard]] OverlayRows overlay_rows(Lod lod) const override;
  [[nodiscard]] bool stands() const override { return true; }
  [[nodiscard]] std::vector<ObjectKindName> object_kinds() const override;
  bool place(const StandingGround& ground, int columns, Placement& at,
             std::vector<PlacedObject>& objects) const override;
  void add_overrides(const ChunkSite& site, std::vector<Override>& overrides) const override;
  void add_tops(const Stacks& stacks, std::span<MaterialId> materials,
                std::span<std::int32_t> rows) const override;

 private:
  struct Candidate;
  [[nodiscard]] std::optional<Candidate> candidate(std::size_t kind, std::int64_t cell_x,
                                                   std::int64_t cell_z) const;
  [[nodiscard]] bool present(const Candidate& candidate, std::int32_t share) const;
  /// `rows` of them at most. False where none is left of the kind.
  bool place_in_cells(const StandingGround& ground, std::int64_t rows, Placement& at,
                      std::vector<PlacedObject>& objects) const;
  [[nodiscard]] std::span<const ModelVoxel> seen(const PlacedObject& object) const;
  bool place_by_columns(const StandingGround& ground, std::int64_t rows, Placement& at,
                        std::vector<PlacedObject>& objects) const;
  /// Calls visit(x, y, z, material) for the voxels of the level that show it, counted from `origin`, a voxel
  /// of the level; for those of the part in front, or all others. At level 0 none at or above `height`, nor
  /// below 0 where there is one; else the visitor leaves them out.
  template <class Visit>
  void for_each_voxel(const PlacedObject& object, Lod lod, bool front, const VoxelPos& origin,
                      std::optional<int> height, const Visit& visit) const;

  std::vector<ObjectKind> kinds_;
  RotatedPoints clumps_;
};

}  // namespace talus::terrain
