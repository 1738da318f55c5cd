// Renames a material that players have placed.
#pragma once

#include <cstdint>
#include <string>

#include <tl/expected.hpp>

#include <talus/store/data_directory.h>

namespace talus::server {

/// Renames the material `from` of the store in `directory`, which must be used exclusively. Its voxels and
/// history stay. Returns the number of its voxels. An error is one line; nothing is changed then.
[[nodiscard]] tl::expected<std::uint64_t, std::string> rename_material(const store::DataDirectory& directory,
                                                                       const std::string& from,
                                                                       const std::string& to);

}  // namespace talus::server
