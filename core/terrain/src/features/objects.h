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

/// The distribution of a kind's objects: one candidate in each square cell of the endless plane.
struct ObjectKind {
  std::string name;
  std::string model;
  std::uint64_t seed = 0;
  int spacing = 0;              // edge of a cell in base columns
  std::int32_t chance_q16 = 0;  // probability of a candidate
  Clumps clumps = Clumps::none;
  bool in_water = false;
  std::optional<std::size_t> share;     // index in PlacesSpec::shares
  std::array<MaterialId, 256> parts{};  // by ModelVoxel::part
  std::vector<ObjectModel> models;      // a candidate draws one
  std::vector<ModelColumns> columns;    // one per model
  std::vector<ModelRows> rows;          // one per model
  std::vector<ModelLevels> levels;      // one per model
  int reach = 0;                        // maximum over all models: columns from the foot
  int top = 0;                          // rows above the ground
  int levels_shown = 0;                 // number of levels, from 0 on; coarser ones omit the kind
};

class Objects final : public Feature {
 public:
  Objects(std::vector<ObjectKind> kinds, RotatedNoise clumps) : kinds_{std::move(kinds)}, clumps_{clumps} {}

  void write_canonical_form(TextWriter& form) const override;
  [[nodiscard]] int halo(Lod lod) const override;
  [[nodiscard]] OverlayRows overlay_rows(Lod lod) const override;
  [[nodiscard]] bool stands() const override { return true; }
  [[nodiscard]] std::vector<ObjectKindName> object_kinds() const override;
  bool place(const StandingGround& ground, int columns, Placement& at,
             std::vector<PlacedObject>& objects) const override;
  [[nodiscard]] bool places(MaterialId material) const override;
  void add_overrides(const ChunkSite& site, std::vector<Override>& overrides) const override;
  void add_tops(const Stacks& stacks, std::span<MaterialId> materials,
                std::span<std::int32_t> rows) const override;

 private:
  struct Candidate;
  struct CellX;
  [[nodiscard]] std::optional<Candidate> candidate(std::size_t kind, const CellX& cell_x,
                                                   std::int64_t cell_z) const;
  [[nodiscard]] bool present(const Candidate& candidate, std::int32_t share) const;
  /// Places at most `rows` rows of candidates. False when no rows of the kind are left.
  bool place_in_cells(const StandingGround& ground, std::int64_t rows, Placement& at,
                      std::vector<PlacedObject>& objects) const;
  [[nodiscard]] std::span<const ModelVoxel> seen(const PlacedObject& object) const;
  bool place_by_columns(const StandingGround& ground, std::int64_t rows, Placement& at,
                        std::vector<PlacedObject>& objects) const;
  /// Calls visit(x, y, z, material) for the object's voxels at a level, relative to `origin`, a voxel of the
  /// level: for its part in front, or for all others. At level 0 with a `height` only for 0 <= y < height;
  /// otherwise the visitor must skip voxels outside.
  template <class Visit>
  void for_each_voxel(const PlacedObject& object, Lod lod, bool front, const VoxelPos& origin,
                      std::optional<int> height, const Visit& visit) const;

  std::vector<ObjectKind> kinds_;
  RotatedPoints clumps_;
};

}  // namespace talus::terrain
