// Checks that a data directory's database matches its store.toml: files of two stores may have been mixed.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include <talus/store/records.h>
#include <talus/voxel/content_hash.h>

namespace talus::store {

/// Compares the id of a database at `meta` with store.toml in `directory`. Without the file `acknowledged`
/// they may differ: talusd gives the store a new id at its next start. An error is one line with a remedy.
[[nodiscard]] tl::expected<void, std::string> check_store_id(const std::filesystem::path& directory,
                                                             const StoreMeta& meta);

/// check_store_id(), then check_acknowledged() (acknowledged_file.h), whose file means nothing for another
/// store's database. Call it first when reading a store in an exclusively used directory.
[[nodiscard]] tl::expected<void, std::string> check_whole_store(const std::filesystem::path& directory,
                                                                const StoreMeta& meta);

/// Fails if talusd would refuse the store for what its meta says, whatever the world: store.toml in
/// `directory` names another world, or the levels were made by another rule.
[[nodiscard]] tl::expected<void, std::string> check_opens(const std::filesystem::path& directory,
                                                          const StoreMeta& meta);

/// Error text for levels made by another rule; nullopt if they were made by this talusd's. The caller
/// prefixes the directory's name.
[[nodiscard]] std::optional<std::string> level_rule_differs(const StoreMeta& meta);

/// Error text for differing ids; the caller prefixes the directory's name.
[[nodiscard]] std::string ids_differ(ContentHash of_database, ContentHash of_store_toml);

}  // namespace talus::store
