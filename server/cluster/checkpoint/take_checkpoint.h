// A checkpoint's tar, made a store where nobody looks yet. What comes is bounded by what its sender announced
// and the disk has, and verified whole before it is a store: names, sizes, checksums, whose it is, and that
// its edits are those that its state's hash says.
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

/// In the stream that the store is to go on with.
struct WantedPlace {
  std::int64_t created_ns = 0;  // of the stream; 0: of any
  std::uint64_t first = 0;      // message that it keeps
};

struct WantedStore {
  ContentHash fingerprint;  // of the world
  std::optional<ContentHash> store_id;
  std::optional<WantedPlace> place{};
};

/// Bytes that have come.
using OnTaken = std::function<void(std::uint64_t done)>;

/// Into `staging`, an empty directory. Its files are on the disk when it returns. An error is one line; what
/// is in `staging` is of no use then.
[[nodiscard]] tl::expected<store::StoreMeta, std::string> take_checkpoint(
    TarSource& source, const std::filesystem::path& staging, const WantedStore& wanted,
    const OnTaken& on_taken);

}  // namespace talus::server
