// A patch of an export, where it belongs in the arrays of the whole region.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <talus/files/npy_file.h>
#include <talus/terrain/field.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/stacks.h>
#include <talus/voxel/chunk.h>

#include "export_plan.h"
#include "failure.h"

namespace talus::tools {

/// What the whole export must know of a patch; it comes to one thread, in the order of patches.
struct PatchSummary {
  std::int32_t rows = 0;                       // of voxels from y0 up to the highest that is not air
  std::vector<terrain::PlacedObject> objects;  // that stand in the patch, or are seen there alone
};

/// Any threads may write patches at once. Plan and files must outlive it.
class PatchWriter {
 public:
  /// `files[i]` is that of plan.arrays[i].
  PatchWriter(const ExportPlan& plan, std::span<const files::NpyFile> files) : plan_{plan}, files_{files} {}

  /// Generates the patch, which lies in the plan's region, and writes it.
  [[nodiscard]] Expected<PatchSummary> write(const terrain::Region& patch) const;

 private:
  using Done = tl::expected<void, files::FileError>;

  [[nodiscard]] Done write_array(const files::NpyFile& file, ExportArray array,
                                 const terrain::Terrain& terrain) const;
  template <typename Field>
  [[nodiscard]] Done write_field(const files::NpyFile& file, std::size_t slice, const terrain::Region& patch,
                                 const Field& field) const;
  [[nodiscard]] Done write_fields(const files::NpyFile& file, const terrain::Region& patch,
                                  const std::vector<terrain::Field>& fields) const;
  [[nodiscard]] Done write_apron(const files::NpyFile& file, const terrain::Terrain& terrain) const;
  [[nodiscard]] Done write_shown(const files::NpyFile& file, const terrain::Terrain& terrain) const;
  [[nodiscard]] Done write_quantities(const files::NpyFile& file, const terrain::Region& patch) const;
  /// How many rows from y0 up are not all air.
  template <typename Item>
  [[nodiscard]] Expected<std::int32_t> write_voxels(const files::NpyFile& file,
                                                    const terrain::Region& patch) const;
  /// With its edits, where there are any.
  [[nodiscard]] Expected<Chunk> chunk_at(const terrain::Stacks& stacks, ChunkKey key) const;
  /// The item of the patch's column (0, z) in the region's array, on its `slice`th plane.
  [[nodiscard]] std::size_t item(const terrain::Region& patch, std::size_t slice, int z) const;

  const ExportPlan& plan_;
  std::span<const files::NpyFile> files_;
};

}  // namespace talus::tools
