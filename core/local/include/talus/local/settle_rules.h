// Rules by which a world's loose material slides after an edit.
#pragma once

#include <talus/edits/settle.h>
#include <talus/terrain/world.h>

namespace talus::local {

/// Includes the world's loose materials, and the loose materials that show in place of them.
[[nodiscard]] edits::SettleRules settle_rules(const terrain::World& world);

}  // namespace talus::local
