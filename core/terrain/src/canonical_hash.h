// Private to the room.
#pragma once

#include <string>

#include <talus/voxel/content_hash.h>

namespace talus::terrain {

[[nodiscard]] ContentHash hash_canonical_form(const std::string& form);

}  // namespace talus::terrain
