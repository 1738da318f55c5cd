// A small file's bytes.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include <tl/expected.hpp>

namespace talus::server {

/// All of the file, or the errno of what failed: EISDIR where it is a directory, EFBIG where it has more than
/// `most_bytes`, as /dev/zero has.
[[nodiscard]] tl::expected<std::string, int> read_file(const std::filesystem::path& file,
                                                       std::size_t most_bytes);

}  // namespace talus::server
