// Features behind the public headers: a world's by their class, and the kinds with a fixture among them.
#pragma once

#include <span>
#include <stdexcept>

#include <talus/terrain/world.h>

#include "feature.h"

namespace talus::terrain {

/// The shipped kinds and the fixture of lava.cpp; defined by tests/terrain/CMakeLists.txt.
[[nodiscard]] std::span<const FeatureKind> features_with_fixture();

}  // namespace talus::terrain

namespace talus::test {

/// Throws where the world has none.
template <class Kind>
[[nodiscard]] const Kind& feature_of(const terrain::World& world) {
  for (const auto& feature : world.features()) {
    if (const auto* found = dynamic_cast<const Kind*>(feature.get())) return *found;
  }
  throw std::runtime_error("the world has no such feature");
}

}  // namespace talus::test
