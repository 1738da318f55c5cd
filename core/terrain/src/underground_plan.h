// What bounds of folds, faults and veins span several keys. Private to the room.
#pragma once

#include <optional>

#include <talus/terrain/world.h>

#include "spec_fault.h"
#include "spec_reader.h"

namespace talus::terrain {

/// What is wrong with what lies in the ground, once the surface's own bounds hold.
[[nodiscard]] std::optional<SpecFault> check_underground(const WorldSpec& spec, const SpecLines& lines);

}  // namespace talus::terrain
