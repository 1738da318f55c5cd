// Files that appear whole or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include <tl/expected.hpp>

namespace talus::cli {

/// Writes a temporary file beside `path` and renames it. A symlink is followed; what is there and is no
/// regular file is left alone. The error is one line that names the file.
[[nodiscard]] tl::expected<void, std::string> write_file(const std::filesystem::path& path,
                                                         std::span<const std::byte> bytes);

}  // namespace talus::cli
