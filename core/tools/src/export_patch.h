// Writes a patch of an export to its place in the arrays of the whole region.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <talus/files/npy_file.h>
#include <talus/terrain/field.h>
#include <talus/terrain/generator.h>
#include <talus/terrain/stacks.h>
#include <talus/tools/failure.h>
#include <talus/voxel/chunk.h>

#include "export_plan.h"

namespace talus::tools {

/// Data of a patch for the whole export; collected by one thread, in the order of patches.
struct PatchSummary {
  std::int32_t rows = 0;                       // rows of voxels from y0 up to the highest that is not air
  std::vector<terrain::PlacedObject> objects;  // that stand in the patch, or are seen only there
};

/// Any number of threads may write patches at once. Plan and files must outlive this object.
class PatchWriter {
 public:
  /// `files[i]` is the file of plan.arrays[i].
  PatchWriter(const ExportPlan& plan, std::span<const files::NpyFile> files) : plan_{plan}, files_{files} {}

  /// Generates and writes the patch, which must lie in the plan's region.
  [[nodiscard]] Expected<PatchSummary> write(const terrain::Region& patch) const;

 private:
  using Status = tl::expected<void, files::FileError>;

  [[nodiscard]] Status write_array(const files::NpyFile& file, ExportArray array,
                                   const terrain::Terrain& terrain) const;
  template <typename Field>
  [[nodiscard]] Status write_field(const files::NpyFile& file, std::size_t slice,
                                   const terrain::Region& patch, const Field& field) const;
  [[nodiscard]] Status write_fields(const files::NpyFile& file, const terrain::Region& patch,
                                    const std::vector<terrain::Field>& fields) const;
  [[nodiscard]] Status write_apron(const files::NpyFile& file, const terrain::Terrain& terrain) const;
  [[nodiscard]] Status write_shown(const files::NpyFile& file, const terrain::Terrain& terrain) const;
  [[nodiscard]] Status write_quantities(const files::NpyFile& file, const terrain::Region& patch) const;
  /// Returns the number of rows from y0 up to the highest that is not all air.
  template <typename Item>
  [[nodiscard]] Expected<std::int32_t> write_voxels(const files::NpyFile& file,
                                                    const terrain::Region& patch) const;
  /// Includes the edits, if any.
  [[nodiscard]] Expected<Chunk> chunk_at(const terrain::Stacks& stacks, ChunkKey key) const;
  /// Index of the patch's column (0, z) in the region's array, in plane `slice`.
  [[nodiscard]] std::size_t item(const terrain::Region& patch, std::size_t slice, int z) const;

  const ExportPlan& plan_;
  std::span<const files::NpyFile> files_;
};

}  // namespace talus::tools
