// Operations on a whole edit store while it is not used otherwise.
#pragma once

#include <filesystem>
#include <string>

#include <tl/expected.hpp>

#include <talus/store/records.h>
#include <talus/voxel/content_hash.h>

namespace talus::store {

/// Copies the database of the store in `path` into its staging directory by linking files. After
/// give_identity() has added the other files, swap_in() makes it the store. Returns the staging directory. An
/// error is one line and leaves the store unchanged.
[[nodiscard]] tl::expected<std::filesystem::path, std::string> stage_copy(const std::filesystem::path& path);

/// Gives the store in `path`, which contains the directory db, a new id, so that clients discard their
/// copies. Also writes the files next to the database, and syncs. An interrupted call leaves a mixture: use
/// it only in staging. An error is one line.
[[nodiscard]] tl::expected<void, std::string> give_identity(const std::filesystem::path& path,
                                                            ContentHash store_id);

/// Sets the store's place in a stream; sequence 0 removes it from any. The id stays.
[[nodiscard]] tl::expected<void, std::string> enter_stream(const std::filesystem::path& path,
                                                           const StreamPlace& place);

/// Rewrites the store's files without deleted or replaced values.
[[nodiscard]] tl::expected<void, std::string> compact(const std::filesystem::path& path);

}  // namespace talus::store
