// Another name for a material that players have placed.
#pragma once

#include <cstdint>
#include <string>

#include <tl/expected.hpp>

#include <talus/store/data_directory.h>

namespace talus::server {

/// The material `from` of the store in `directory`, which nobody else uses, is called `to`: its voxels and
/// its history are as they were. Returns how many voxels that are. An error is one line, and nothing is
/// changed.
[[nodiscard]] tl::expected<std::uint64_t, std::string> rename_material(const store::DataDirectory& directory,
                                                                       const std::string& from,
                                                                       const std::string& to);

}  // namespace talus::server
