// Checks output paths before the work starts.
#pragma once

#include <filesystem>
#include <string>

#include <tl/expected.hpp>

namespace talus::cli {

/// Fails, with one line, unless `path` is empty or names a file in a writable folder.
[[nodiscard]] tl::expected<void, std::string> check_output(const std::filesystem::path& path);

}  // namespace talus::cli
