// Whether this process may write to a folder.
#pragma once

#include <filesystem>
#include <system_error>

namespace talus::cli {

/// Empty if files can be created in `folder`; otherwise the system's reason.
[[nodiscard]] std::error_code check_writable(const std::filesystem::path& folder);

}  // namespace talus::cli
