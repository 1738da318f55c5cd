// Replaces the store of a data directory atomically, even if the process or the power fails at any moment.
//
// The new store is built in the directory `talus-staging`. Once renamed to `talus-next` it is the valid one,
// and its parts are moved into place; the next process to open the directory completes an interrupted swap.
// All calls require the directory's lock.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace talus::store {

/// Creates an empty directory for the new store, deleting leftovers of another process.
[[nodiscard]] tl::expected<std::filesystem::path, std::string> make_staging(
    const std::filesystem::path& directory);

/// File in a data directory with the reason why its store must not be used any more.
inline constexpr std::string_view kRejoinName = "rejoin";

/// Fate of the replaced store: deleted if it had the same edits as the new one, otherwise kept.
enum class ReplacedStore { stays, goes };

/// Makes the complete and synced store in `staging` the directory's store, and removes kRejoinName, which was
/// about the previous store. Returns the path where the previous store is kept; empty if it did not exist or
/// was deleted.
[[nodiscard]] tl::expected<std::filesystem::path, std::string> swap_in(
    const std::filesystem::path& directory, ReplacedStore replaced = ReplacedStore::stays);

/// True if a swap was interrupted or failed after the new store became valid: tidy_up() completes it.
[[nodiscard]] bool swap_is_begun(const std::filesystem::path& directory);

/// Renames `replaced`, which swap_in() returned, as a store replaced by another server's. This may repeat
/// without end, so only the newest two are kept. Returns the new path.
[[nodiscard]] tl::expected<std::filesystem::path, std::string> keep_rejoined(
    const std::filesystem::path& directory, const std::filesystem::path& replaced);

/// Completes an interrupted swap, and deletes unfinished work: staging and checkpoints.
[[nodiscard]] tl::expected<void, std::string> tidy_up(const std::filesystem::path& directory);

/// Path of a checkpoint in a data directory. Its creator deletes it; after a crash tidy_up() does.
[[nodiscard]] std::filesystem::path checkpoint_path(const std::filesystem::path& directory,
                                                    std::string_view name);

/// A checkpoint copies only RocksDB's log of unflushed data, at most four write buffers; all else is linked.
inline constexpr std::uint64_t kCheckpointCopiesBytes = std::uint64_t{128} << 20U;

/// Empties the directory `path` and calls `make` with a path in it to write the database's checkpoint. Fails
/// without calling it if the disk has less than `copied_bytes` free. On error leaves nothing.
[[nodiscard]] tl::expected<void, std::string> make_checkpoint(
    const std::filesystem::path& path, std::uint64_t copied_bytes,
    const std::function<tl::expected<void, std::string>(const std::filesystem::path&)>& make);

/// Syncs the directory's entries to the disk.
[[nodiscard]] tl::expected<void, std::string> sync_directory(const std::filesystem::path& directory);

/// Fails if the disk has less than `bytes` plus a reserve for other writes free.
[[nodiscard]] tl::expected<void, std::string> check_space(const std::filesystem::path& directory,
                                                          std::uint64_t bytes);

}  // namespace talus::store
