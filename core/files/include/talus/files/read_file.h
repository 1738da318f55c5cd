// Reads small files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include <tl/expected.hpp>

#include <talus/files/file_error.h>
#include <talus/files/file_layer.h>

namespace talus::files {

/// Reads all of a file, which may be a pipe. Fails with is_a_directory for a directory, and with
/// file_too_large if there are more than `max_bytes`, as in /dev/zero; never reads more than that.
[[nodiscard]] tl::expected<std::string, FileError> read_file(const std::filesystem::path& file,
                                                             std::size_t max_bytes,
                                                             FileLayer& layer = system_files());

/// Like read_file(), but rejects a file that is not regular, with an empty code: it never waits for a pipe's
/// writer.
[[nodiscard]] tl::expected<std::string, FileError> read_regular_file(const std::filesystem::path& file,
                                                                     std::size_t max_bytes,
                                                                     FileLayer& layer = system_files());

}  // namespace talus::files
