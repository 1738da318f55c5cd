// What a material may be called: in a world's file, and where a store gives one another name.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace talus {

/// Bytes of a material's name.
inline constexpr std::size_t kMaxMaterialNameBytes = 64;

/// Why no material that a world names may be called so, in one line; nothing where one may. Any bytes may be
/// asked for.
[[nodiscard]] std::optional<std::string> material_name_fault(std::string_view name);

}  // namespace talus
