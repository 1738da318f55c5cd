// export.json: describes the arrays of an export.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <talus/terrain/objects.h>

#include "export_plan.h"

namespace talus::tools {

/// `rows`: rows of voxels.npy.
[[nodiscard]] std::string export_json(const ExportPlan& plan, std::size_t rows);

/// objects.json: the region's objects, by kind, then from north-west on.
[[nodiscard]] std::string objects_json(const ExportPlan& plan, std::vector<terrain::PlacedObject> objects);

/// Shape of an array of the plan. `rows`: rows of voxels.npy.
[[nodiscard]] std::vector<std::size_t> shape_of(const ExportPlan& plan, const PlannedArray& array,
                                                std::size_t rows);

}  // namespace talus::tools
