// Turns a single server's store into the first of a cluster. The store must be unused.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include <tl/expected.hpp>

#include <talus/edits/settle.h>
#include <talus/store/records.h>

#include "cluster/log_stream.h"

namespace talus::server::join {

/// Starts the empty stream with the state of the store in `directory`, and enters the store as its first
/// reader. An interrupted call can be repeated. Returns the store's meta. An error is one line, and names the
/// stream if it was already started by something else.
[[nodiscard]] tl::expected<store::StoreMeta, std::string> enter_cluster(
    const std::filesystem::path& directory, const edits::SettleRules& settles, LogStream& stream);

/// Reads the meta of the store in `directory`, verifying that nothing acknowledged is missing and that
/// database and store.toml belong together.
[[nodiscard]] tl::expected<store::StoreMeta, std::string> read_place(const std::filesystem::path& directory);

}  // namespace talus::server::join
