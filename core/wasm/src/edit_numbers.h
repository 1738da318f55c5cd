// Edits as a host writes them.
#pragma once

#include <optional>
#include <span>

#include <talus/edits/edit.h>

namespace talus::wasm {

/// How many guards, writes and fills there are; of each guard and write x, y, z and a material; of each fill
/// both corners, its material and the one that alone changes, or -1 for nullopt. nullopt if the numbers are
/// not that.
[[nodiscard]] std::optional<edits::Edit> edit_of(std::span<const double> numbers);

}  // namespace talus::wasm
