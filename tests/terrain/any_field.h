// A field of numbers that rapidcheck draws.
#pragma once

#include <rapidcheck.h>

#include <cstdint>

#include <talus/terrain/field.h>

namespace talus::terrain {

/// Each from 0 to `most`.
[[nodiscard]] inline Field any_field(int width, int depth, std::int32_t most) {
  Field field{width, depth};
  for (std::int32_t& value : field.values) value = *rc::gen::inRange(0, most + 1);
  return field;
}

}  // namespace talus::terrain
