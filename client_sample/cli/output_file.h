// Files that appear whole or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include <tl/expected.hpp>

namespace talus::cli {

/// Writes beside `path` and renames; the error is one line that names the file.
[[nodiscard]] tl::expected<void, std::string> write_file(const std::filesystem::path& path,
                                                         std::span<const std::byte> bytes);

}  // namespace talus::cli
