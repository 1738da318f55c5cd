// Whether a material of a store may get another name.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include <talus/edits/materials.h>

namespace talus::store {

/// The id of the material `from` of a store with these names, where it may be called `to`. An error is one
/// line without the store's place, and holds the names as they are.
[[nodiscard]] tl::expected<MaterialId, std::string> check_rename(const edits::MaterialIds& materials,
                                                                 const std::string& from,
                                                                 const std::string& to);

}  // namespace talus::store
