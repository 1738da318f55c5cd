// Combines pictures into one.
#pragma once

#include <span>

#include <talus/tools/image.h>

namespace talus::tools {

/// Arranges pictures of one size in rows of `across` from the top left, with white gaps.
[[nodiscard]] Image join_panels(std::span<const Image> panels, int across);

}  // namespace talus::tools
