// What is done to a store of edits as a whole, while nobody else uses it.
#pragma once

#include <filesystem>
#include <string>

#include <tl/expected.hpp>

#include <talus/store/records.h>
#include <talus/voxel/content_hash.h>

namespace talus::store {

/// Of the database of the store in `path` into its staging directory, of which swap_in() makes a store when
/// it has the files that give_identity() writes. Files are linked, not copied. Returns the staging directory.
/// An error is one line; the store is as it was.
[[nodiscard]] tl::expected<std::filesystem::path, std::string> stage_copy(const std::filesystem::path& path);

/// The store in `path`, which has the directory db, is another from now on: clients drop what they know of
/// it. Writes the files beside the database too; all is on the disk when it returns. Interrupted it leaves
/// half of each: only for a store in staging. An error is one line.
[[nodiscard]] tl::expected<void, std::string> give_identity(const std::filesystem::path& path,
                                                            ContentHash store_id);

/// The store stands there in a stream from now on, or, at 0, in none. Its id stays.
[[nodiscard]] tl::expected<void, std::string> enter_stream(const std::filesystem::path& path,
                                                           const StreamPlace& place);

/// Writes its files anew, without what was deleted or replaced.
[[nodiscard]] tl::expected<void, std::string> compact(const std::filesystem::path& path);

}  // namespace talus::store
