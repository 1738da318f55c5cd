// How many sockets the system lets this process hold.
#pragma once

#include <cstdint>

namespace talus::server {

/// Raises the process's limit of open files to `wanted` where that is allowed; returns what it is now.
[[nodiscard]] std::uint64_t raise_descriptor_limit(std::uint64_t wanted);

}  // namespace talus::server
