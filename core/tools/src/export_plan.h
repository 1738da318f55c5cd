// Arrays of an export of a region, and their slices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <talus/files/npy_file.h>
#include <talus/terrain/field.h>
#include <talus/terrain/world.h>
#include <talus/voxel/material.h>

#include "land_edits.h"

namespace talus::tools {

enum class ExportArray : std::uint8_t {
  surface,
  slope,
  apron,
  place,
  eroded,
  strata,
  shown,
  fields,
  look,
  voxels,
};

struct PlannedArray {
  ExportArray array{};
  std::string file;
  files::NpyType type{};
  /// Length of the axis before z and x, which `axis` names; nullopt: the array is [z][x]. For voxels, the
  /// maximum number of rows.
  std::optional<std::size_t> slices{};
  std::string axis{};
  std::string unit{};
  std::string meaning{};
};

/// Factor of the values in fields.npy.
inline constexpr std::int32_t kFieldScale = 65536;

/// World and edits must outlive this object.
struct ExportPlan {
  const terrain::World* world = nullptr;
  const LandEdits* edits = nullptr;  // applied to voxels.npy; null: no edits
  terrain::Region region;
  /// The lowest row of voxels: everything below is the first layer's material. At coarse levels the topmost
  /// solid voxel, and what it shows, may lie just below y = 0; edits may lie anywhere.
  std::int32_t y0 = 0;
  std::vector<MaterialId> layers;   // in strata.npy, bottom up
  std::vector<MaterialId> planes;   // in shown.npy: the layers, loose material bottom up, water
  std::vector<std::string> fields;  // in fields.npy
  std::string slope_of;             // the land described by slope.npy
  std::vector<PlannedArray> arrays;
  std::vector<std::string> left_out;  // files that exports of other worlds have

  /// Maximum bytes of a column in all arrays together.
  [[nodiscard]] std::size_t column_bytes() const;
};

[[nodiscard]] ExportPlan plan_export(const terrain::World& world, const terrain::Region& region,
                                     const LandEdits* edits = nullptr);

}  // namespace talus::tools
