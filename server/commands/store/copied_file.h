// Copies files, hashing them on the way.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include <tl/expected.hpp>

#include <talus/progress/progress_bar.h>
#include <talus/voxel/content_hash.h>

namespace talus::server {

struct CopiedFile {
  std::uint64_t bytes = 0;
  ContentHash hash;  // XXH3-128 of the bytes
  bool all = false;  // the end of the file was reached
};

/// Copies at most the first `max_bytes` bytes of a regular file, and never reads more. Syncs; `to` is
/// complete or absent. Advances `progress` by bytes. An error is one line.
[[nodiscard]] tl::expected<CopiedFile, std::string> copy_file(const std::filesystem::path& from,
                                                              const std::filesystem::path& to,
                                                              std::uint64_t max_bytes, ProgressBar& progress);
[[nodiscard]] tl::expected<CopiedFile, std::string> hash_file(const std::filesystem::path& file,
                                                              ProgressBar& progress);

}  // namespace talus::server
