// export.json: what the arrays of an export mean.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <talus/terrain/objects.h>

#include "export_plan.h"

namespace talus::tools {

/// `rows`: of voxels.npy.
[[nodiscard]] std::string export_json(const ExportPlan& plan, std::size_t rows);

/// objects.json: what stands in the region, by kind, then from north-west on.
[[nodiscard]] std::string objects_json(const ExportPlan& plan, std::vector<terrain::PlacedObject> objects);

/// The shape of an array of the plan. `rows`: of voxels.npy.
[[nodiscard]] std::vector<std::size_t> shape_of(const ExportPlan& plan, const PlannedArray& array,
                                                std::size_t rows);

}  // namespace talus::tools
