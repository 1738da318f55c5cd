// Output of `talusd store history`.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include <talus/store/read_only_store.h>

#include "commands/store/history.h"

namespace talus::server {

/// Prints lines or a part of a JSON document, at most kPageBytes and one line per call.
using Print = std::function<void(std::string_view)>;
inline constexpr std::size_t kPageBytes = std::size_t{64} << 10U;

// Each prints while it reads the records. An error is one line; a JSON document is then incomplete.

[[nodiscard]] tl::expected<void, std::string> print_history(const store::ReadOnlyStore& store, VoxelPos voxel,
                                                            bool json, const Print& print);
[[nodiscard]] tl::expected<void, std::string> print_history(const store::ReadOnlyStore& store,
                                                            const SubjectQuery& query, bool json,
                                                            const Print& print);

}  // namespace talus::server
