// A store of one machine that becomes the first of a cluster, and the way back. While nobody uses the store.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include <tl/expected.hpp>

#include <talus/edits/settle.h>
#include <talus/store/records.h>

#include "cluster/log_stream.h"

namespace talus::server::join {

/// The stream, which is empty, begins with the store in `directory` as it stands, and the store is the first
/// that has read it. Interrupted, it is simply done again. Returns where the store stands. An error is one
/// line, and names the stream where that is begun by something else.
[[nodiscard]] tl::expected<store::StoreMeta, std::string> enter_cluster(
    const std::filesystem::path& directory, const edits::SettleRules& settles, LogStream& stream);

/// Where the store in `directory` stands; it has all that was acknowledged, and its
/// database and its store.toml are of one store.
[[nodiscard]] tl::expected<store::StoreMeta, std::string> read_place(const std::filesystem::path& directory);

}  // namespace talus::server::join
