// What an export of a region consists of: its arrays, and what their slices are.
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
  /// Along the axis before z and x, which `axis` names; none: the array is [z][x]. Of voxels it is the most
  /// rows that the world can need.
  std::optional<std::size_t> slices{};
  std::string axis{};
  std::string unit{};
  std::string meaning{};
};

/// Of fields.npy: values times this.
inline constexpr std::int32_t kFieldScale = 65536;

/// World and edits must outlive it.
struct ExportPlan {
  const terrain::World* world = nullptr;
  const LandEdits* edits = nullptr;  // which voxels.npy has; null: none
  terrain::Region region;
  /// The lowest row of voxels: below it all is the first layer's material. At coarse levels the topmost solid
  /// voxel, and what it shows, may lie just below y = 0; edits may lie anywhere.
  std::int32_t y0 = 0;
  std::vector<MaterialId> layers;   // of strata.npy, bottom up
  std::vector<MaterialId> planes;   // of shown.npy: the layers, loose material bottom up, water
  std::vector<std::string> fields;  // of fields.npy
  std::string slope_of;             // which land slope.npy is of
  std::vector<PlannedArray> arrays;
  std::vector<std::string> left_out;  // files that other worlds' exports have

  /// Bytes that a column can take in all arrays together.
  [[nodiscard]] std::size_t column_bytes() const;
};

[[nodiscard]] ExportPlan plan_export(const terrain::World& world, const terrain::Region& region,
                                     const LandEdits* edits = nullptr);

}  // namespace talus::tools
