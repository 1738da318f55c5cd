// What `talusd store history` prints.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include <talus/store/read_only_store.h>

#include "commands/store/history.h"

namespace talus::server {

/// Some lines, or a part of a JSON document. What is printed at once is no more than kPageBytes and a line.
using Print = std::function<void(std::string_view)>;
inline constexpr std::size_t kPageBytes = std::size_t{64} << 10U;

// Each reads the records as it prints. An error is one line: what was printed until then is no whole
// document.

[[nodiscard]] tl::expected<void, std::string> print_history(const store::ReadOnlyStore& store, VoxelPos voxel,
                                                            bool json, const Print& print);
[[nodiscard]] tl::expected<void, std::string> print_history(const store::ReadOnlyStore& store,
                                                            const SubjectQuery& query, bool json,
                                                            const Print& print);

}  // namespace talus::server
