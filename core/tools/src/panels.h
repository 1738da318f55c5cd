// Several pictures as one.
#pragma once

#include <span>

#include "image.h"

namespace talus::tools {

/// Pictures of one size in rows of `across`, from the top left, with white between them.
[[nodiscard]] Image join_panels(std::span<const Image> panels, int across);

}  // namespace talus::tools
