// The text whose hash is a world's fingerprint. Private to core/terrain.
#pragma once

#include <string>

#include <talus/voxel/content_hash.h>

namespace talus::terrain {

/// The bits of a float, so that different numbers have different text.
[[nodiscard]] std::string bits_of(float value);

[[nodiscard]] ContentHash hash_canonical_form(const std::string& form);

}  // namespace talus::terrain
