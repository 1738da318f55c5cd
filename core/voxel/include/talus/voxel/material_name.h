// Rules for names of materials, in world files and in stores.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace talus {

/// Maximum bytes of a material's name.
inline constexpr std::size_t kMaxMaterialNameBytes = 64;

/// Returns the reason, in one line, why a world's material may not have this name; nullopt if it may. `name`
/// may be any bytes.
[[nodiscard]] std::optional<std::string> material_name_fault(std::string_view name);

}  // namespace talus
