// A store that takes the place of another in a data directory, whole or not at all, whenever the process or
// the power ends.
//
// The new one is made in the directory `talus-staging`. Renamed to `talus-next` it is the one that counts,
// and its parts are moved to where a store's parts are; who opens the directory next ends what was
// interrupted. All calls are for who has the directory's lock.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace talus::store {

/// Where the new store is made: an empty directory. What another process left there is gone.
[[nodiscard]] tl::expected<std::filesystem::path, std::string> make_staging(
    const std::filesystem::path& directory);

/// The file in a data directory that says why the store there must not be used any more.
inline constexpr std::string_view kRejoinName = "rejoin";

/// What becomes of a store that is replaced: it goes where it had the same edits.
enum class Replaced { stays, goes };

/// The store in `staging`, whose files are whole and synced, is the directory's from now on, and what
/// kRejoinName said of the one before is gone. Returns where that is kept; empty where there was none, or it
/// went.
[[nodiscard]] tl::expected<std::filesystem::path, std::string> swap_in(const std::filesystem::path& directory,
                                                                       Replaced replaced = Replaced::stays);

/// Whether a swap was interrupted, or failed, when the new store counted already: tidy_up() ends it.
[[nodiscard]] bool swap_is_begun(const std::filesystem::path& directory);

/// `replaced`, which swap_in() returned, was replaced because its server took another's store: a server may
/// do that again and again, so of such no more than the newest two are kept. Returns where it is then.
[[nodiscard]] tl::expected<std::filesystem::path, std::string> keep_rejoined(
    const std::filesystem::path& directory, const std::filesystem::path& replaced);

/// Ends a swap that was interrupted, and removes what was not finished: staging, and checkpoints.
[[nodiscard]] tl::expected<void, std::string> tidy_up(const std::filesystem::path& directory);

/// The name of a checkpoint below a data directory. Whoever made it removes it; tidy_up() does where it was
/// killed.
[[nodiscard]] std::filesystem::path checkpoint_path(const std::filesystem::path& directory,
                                                    std::string_view name);

/// What a checkpoint copies is RocksDB's log, of what is not flushed: four write buffers at most. All else is
/// linked.
inline constexpr std::uint64_t kCheckpointCopiesBytes = std::uint64_t{128} << 20U;

/// `make`, which is given a path in it, makes the database's checkpoint in the directory `path`, which is
/// empty then. Where the disk has less than `copied_bytes` free none is made; after an error nothing is left.
[[nodiscard]] tl::expected<void, std::string> make_checkpoint(
    const std::filesystem::path& path, std::uint64_t copied_bytes,
    const std::function<tl::expected<void, std::string>(const std::filesystem::path&)>& make);

/// Returns when the directory's names are on the disk.
[[nodiscard]] tl::expected<void, std::string> sync_directory(const std::filesystem::path& directory);

/// Refuses where the disk has less than `bytes` free, and some more for what else is written there.
[[nodiscard]] tl::expected<void, std::string> check_space(const std::filesystem::path& directory,
                                                          std::uint64_t bytes);

}  // namespace talus::store
