// A chunk's voxels in one of three forms: layers (boundary planes, as the generator makes them), layers with
// a list of single voxels that differ (objects and edits), or dense voxels (anything). Immutable, so any
// number of threads may read a chunk.
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

/// The boundary view: `materials` from bottom to top, with a plane between neighbours. For each column (z
/// slowest, then x), plane p holds the row 0 to 32 at which materials[p] ends and materials[p + 1] begins;
/// planes do not cross. A material may occur more than once, so stacks with holes (air between layers) fit.
/// Without planes the chunk is uniform.
struct Layers {
  static constexpr std::size_t kMaxMaterials = 64;  // the planes of a full list are as large as dense voxels

  std::vector<MaterialId> materials;  // 1 to kMaxMaterials
  std::vector<std::uint8_t> tops;     // (materials.size() - 1) * 1024

  [[nodiscard]] std::size_t plane_count() const { return materials.size() - 1; }
  [[nodiscard]] std::span<const std::uint8_t> plane(std::size_t index) const {
    return std::span{tops}.subspan(index * kChunkArea, kChunkArea);
  }
  /// True if the sizes, row range and order of planes are as described above.
  [[nodiscard]] bool valid() const;
};

/// A vertical run of one material in a column: rows `from` (inclusive) to `to` (exclusive), 0 to 32.
struct Run {
  MaterialId material{};
  std::uint8_t from = 0;
  std::uint8_t to = 0;
  bool operator==(const Run&) const = default;
};

/// A voxel that differs from its chunk's layers. `index` is its voxel_index().
struct Override {
  std::uint16_t index = 0;
  MaterialId material{};
  bool operator==(const Override&) const = default;
};

class Chunk {
 public:
  /// A chunk with more overrides is held as dense voxels: copying out this many takes as long as copying
  /// dense voxels, which need four times their memory.
  static constexpr std::size_t kMaxOverrides = 4096;

  [[nodiscard]] static Chunk uniform(MaterialId material);
  /// REQUIRES: layers.valid() (asserted). Redundant planes are removed.
  [[nodiscard]] static Chunk from_layers(Layers layers);
  /// Copies `voxels`; a chunk of one material becomes uniform.
  [[nodiscard]] static Chunk from_dense(std::span<const MaterialId, kChunkVolume> voxels);
  /// Shares `voxels`, which must not change afterwards; a chunk of one material becomes uniform.
  [[nodiscard]] static Chunk from_dense(std::shared_ptr<const DenseVoxels> voxels);

  /// Returns the chunk with other materials at some voxels, in any order; the last override of a voxel
  /// counts. Layers remain layers, with at most kMaxOverrides overrides. REQUIRES: every index < kChunkVolume
  /// (asserted).
  [[nodiscard]] Chunk with_overrides(std::span<const Override> overrides) const;

  [[nodiscard]] bool is_uniform() const;
  [[nodiscard]] MaterialId at(LocalPos pos) const;
  /// The column's runs from bottom to top, covering rows 0 to 32; adjacent runs differ in material.
  [[nodiscard]] std::vector<Run> runs(int x, int z) const;
  void copy_to(std::span<MaterialId, kChunkVolume> voxels) const;

  /// The boundary view; null if the chunk has overrides or is held as dense voxels.
  [[nodiscard]] const Layers* layers() const { return std::get_if<Layers>(&form_); }
  /// The dense voxels, valid as long as the chunk; null if the chunk is held otherwise.
  [[nodiscard]] const DenseVoxels* dense() const;
  /// The voxels that differ from base(), by ascending index; empty if the chunk has no overrides.
  [[nodiscard]] std::span<const Override> overrides() const;
  /// The layers below the overrides; null if the chunk has no overrides.
  [[nodiscard]] const Layers* base() const;
  /// Moves out the boundary view, to reuse its memory; without materials if layers() is null. Afterwards the
  /// chunk may only be assigned to or destroyed.
  [[nodiscard]] Layers take_layers() &&;

  /// Compares voxels, regardless of their form.
  friend bool operator==(const Chunk& a, const Chunk& b);

 private:
  using Dense = std::shared_ptr<const DenseVoxels>;
  struct OverriddenLayers {
    Layers base;
    std::vector<Override> overrides;  // by ascending index, without duplicates; each differs from the base
  };
  using Form = std::variant<Layers, OverriddenLayers, Dense>;
  explicit Chunk(Form form) : form_{std::move(form)} {}
  Form form_;
};

}  // namespace talus
