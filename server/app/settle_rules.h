// By which rules loose material of a world slides where an edit sets it loose.
#pragma once

#include <talus/edits/settle.h>
#include <talus/terrain/world.h>

namespace talus::server {

/// Of the world's loose materials, and of what shows in place of them and is loose too.
[[nodiscard]] edits::SettleRules settle_rules(const terrain::World& world);

}  // namespace talus::server
