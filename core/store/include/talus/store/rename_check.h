// Checks the renaming of a store's material.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include <talus/edits/materials.h>

namespace talus::store {

/// Returns the id of the material `from` if it may be renamed to `to`. An error is one line without the
/// store's path, and contains the names unescaped.
[[nodiscard]] tl::expected<MaterialId, std::string> check_rename(const edits::MaterialIds& materials,
                                                                 const std::string& from,
                                                                 const std::string& to);

}  // namespace talus::store
