// A small file's bytes.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include <tl/expected.hpp>

#include <talus/files/file_error.h>
#include <talus/files/file_layer.h>

namespace talus::files {

/// All of the file, which may be a pipe. The error's code is is_a_directory for a directory, and
/// file_too_large where the file has more than `max_bytes`, as /dev/zero has; no more than that is ever read.
[[nodiscard]] tl::expected<std::string, FileError> read_file(const std::filesystem::path& file,
                                                             std::size_t max_bytes,
                                                             FileLayer& layer = system_files());

/// As read_file(), but refuses what is no regular file, with an empty code: nothing waits for a pipe's
/// writer.
[[nodiscard]] tl::expected<std::string, FileError> read_regular_file(const std::filesystem::path& file,
                                                                     std::size_t max_bytes,
                                                                     FileLayer& layer = system_files());

}  // namespace talus::files
