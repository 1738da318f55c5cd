// A file that is either as it was or wholly new, also after a power cut.
#pragma once

#include <filesystem>
#include <string_view>

namespace talus::server {

/// Writes beside `file`, syncs, and renames over it. Returns 0 or the errno of the step that failed.
[[nodiscard]] int write_atomically(const std::filesystem::path& file, std::string_view content);

}  // namespace talus::server
