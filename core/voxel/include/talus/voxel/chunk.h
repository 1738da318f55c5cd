// A chunk's voxels, in the form in which they came: layers (boundary planes, as the generator makes them),
// layers and a list of single voxels that differ from them (objects and edits), or dense voxels (anything).
// Immutable once made, so one chunk may be read by any number of threads.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include <talus/voxel/coords.h>
#include <talus/voxel/material.h>

namespace talus {

/// All voxels of a chunk, index (y * 32 + z) * 32 + x: 64 KiB.
using DenseVoxels = std::array<MaterialId, kChunkVolume>;

/// The boundary view: `materials` bottom up, with a plane between each and the next. Plane p holds, for
/// each column (z slowest, then x), the row 0 to 32 at which materials[p] ends and materials[p + 1]
/// begins; no plane lies below the one before it. A material may stand in the list more than once, so
/// stacks with holes (air between layers) fit. No planes: the chunk is uniform.
struct Layers {
  static constexpr std::size_t kMaxMaterials = 64;  // the planes of a full list are as large as dense voxels

  std::vector<MaterialId> materials;  // 1 to kMaxMaterials
  std::vector<std::uint8_t> tops;     // (materials.size() - 1) * 1024

  [[nodiscard]] std::size_t plane_count() const { return materials.size() - 1; }
  [[nodiscard]] std::span<const std::uint8_t> plane(std::size_t index) const {
    return std::span{tops}.subspan(index * kChunkArea, kChunkArea);
  }
  /// Whether sizes, row range and the order of the planes are as described above.
  [[nodiscard]] bool valid() const;
};

/// A vertical run of one material inside a column: rows `from` (inclusive) to `to` (exclusive), 0 to 32.
struct Run {
  MaterialId material{};
  std::uint8_t from = 0;
  std::uint8_t to = 0;
  bool operator==(const Run&) const = default;
};

/// A voxel that differs from the layers under it. `index` is its voxel_index().
struct Override {
  std::uint16_t index = 0;
  MaterialId material{};
  bool operator==(const Override&) const = default;
};

class Chunk {
 public:
  /// A chunk with more overrides than this is held as dense voxels: copying them out then takes longer than
  /// copying dense voxels does, for a quarter of the memory.
  static constexpr std::size_t kMaxOverrides = 4096;

  [[nodiscard]] static Chunk uniform(MaterialId material);
  /// `layers` must be valid(); this is asserted, not checked. Planes that bound nothing are removed, so
  /// equal voxels given with needless planes cost nothing.
  [[nodiscard]] static Chunk from_layers(Layers layers);
  /// Copies `voxels`; a chunk of one material becomes uniform.
  [[nodiscard]] static Chunk from_dense(std::span<const MaterialId, kChunkVolume> voxels);
  /// Shares `voxels`, which nobody may change any more; a chunk of one material becomes uniform.
  [[nodiscard]] static Chunk from_dense(std::shared_ptr<const DenseVoxels> voxels);

  /// The chunk with other materials at some voxels, in any order; of two for one voxel the later counts.
  /// Layers stay layers, with at most kMaxOverrides overrides. REQUIRES: every index < kChunkVolume
  /// (asserted).
  [[nodiscard]] Chunk with_overrides(std::span<const Override> overrides) const;

  [[nodiscard]] bool is_uniform() const;
  [[nodiscard]] MaterialId at(LocalPos pos) const;
  /// The column's runs from bottom to top, neighbours of one material joined; they cover rows 0 to 32.
  [[nodiscard]] std::vector<Run> runs(int x, int z) const;
  void copy_to(std::span<MaterialId, kChunkVolume> voxels) const;

  /// The boundary view, or null where the chunk has overrides or is held as dense voxels.
  [[nodiscard]] const Layers* layers() const { return std::get_if<Layers>(&form_); }
  /// The dense voxels, or null where the chunk is held otherwise. They live as long as the chunk.
  [[nodiscard]] const DenseVoxels* dense() const;
  /// The voxels that differ from base(), by rising index; none where the chunk is held otherwise.
  [[nodiscard]] std::span<const Override> overrides() const;
  /// The layers under overrides, or null where there are none.
  [[nodiscard]] const Layers* base() const;
  /// The boundary view, for the sake of its memory; without materials where layers() is null. The chunk can
  /// then only be assigned to or destroyed.
  [[nodiscard]] Layers take_layers() &&;

  /// The same voxels, whatever the form.
  friend bool operator==(const Chunk& a, const Chunk& b);

 private:
  using Dense = std::shared_ptr<const DenseVoxels>;
  struct Overridden {
    Layers base;
    std::vector<Override>
        overrides;  // each index once, rising; none with the material that the base has there
  };
  using Form = std::variant<Layers, Overridden, Dense>;
  explicit Chunk(Form form) : form_{std::move(form)} {}
  Form form_;
};

}  // namespace talus
