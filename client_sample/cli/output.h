// Where results go, looked at before the work, so that none is lost.
#pragma once

#include <filesystem>
#include <string>

#include <tl/expected.hpp>

namespace talus::cli {

/// Whether `path`, where it is not empty, names a file in a folder that can be written to. The error is one
/// line.
[[nodiscard]] tl::expected<void, std::string> check_output(const std::filesystem::path& path);

}  // namespace talus::cli
