#pragma once

#include <memory>

#include "chunks/generation/generator.h"

namespace talus::server {

/// What is made, after all its steps.
template <typename Product>
[[nodiscard]] Product made_whole(std::unique_ptr<Build<Product>> build) {
  while (build->step()) continue;
  return build->take();
}

}  // namespace talus::server
