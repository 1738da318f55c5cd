// Whether a data directory's database is that of its store.toml: files of two stores may have been mixed.
#pragma once

#include <filesystem>
#include <string>

#include <tl/expected.hpp>

#include <talus/store/records.h>
#include <talus/voxel/content_hash.h>

namespace talus::store {

/// The database of a store in `directory` stands where `meta` says. Without the file acknowledged they may
/// differ: talusd gives the store a new id at its next start. An error is one line, and says what to do.
[[nodiscard]] tl::expected<void, std::string> check_store_id(const std::filesystem::path& directory,
                                                             const StoreMeta& meta);

/// That, and then whether the database has all that was acknowledged (acknowledged_file.h): of another
/// store's database the file says nothing. Whoever reads a store in a directory that nobody else uses calls
/// it first.
[[nodiscard]] tl::expected<void, std::string> check_whole_store(const std::filesystem::path& directory,
                                                                const StoreMeta& meta);

/// What is said where they differ, behind the name of the directory.
[[nodiscard]] std::string ids_differ(ContentHash of_database, ContentHash of_store_toml);

}  // namespace talus::store
