// Unpacks a checkpoint's tar into a store in a staging directory. The input is bounded by its announced size
// and the free space, and verified completely before it counts as a store: names, sizes, checksums, the
// identity, and that its edits match its state hash.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include <talus/store/records.h>
#include <talus/voxel/content_hash.h>

#include "cluster/checkpoint/tar_source.h"

namespace talus::server {

/// Required relation of the store to the stream.
struct WantedPlace {
  std::int64_t created_ns = 0;  // of the stream; 0: any
  std::uint64_t first = 0;      // oldest message that the stream keeps
};

struct WantedStore {
  ContentHash fingerprint;  // the world's
  std::optional<ContentHash> store_id;
  std::optional<WantedPlace> place{};
};

/// Reports the number of bytes received.
using OnTaken = std::function<void(std::uint64_t done)>;

/// Unpacks into `staging`, an empty directory, and syncs. An error is one line; then the content of `staging`
/// is useless.
[[nodiscard]] tl::expected<store::StoreMeta, std::string> take_checkpoint(
    TarSource& source, const std::filesystem::path& staging, const WantedStore& wanted,
    const OnTaken& on_taken);

}  // namespace talus::server
