// How many files and sockets the system lets this process hold.
#pragma once

#include <cstddef>
#include <cstdint>

namespace talus::server {

/// What a server of so many sockets and io_contexts needs, its listening sockets and files included.
[[nodiscard]] std::uint64_t descriptors_needed(std::uint64_t sockets, std::size_t io_contexts);

/// Sets the process's own limit of open files to `wanted`, or to what the system allows it if that is less;
/// returns what it is now.
[[nodiscard]] std::uint64_t set_descriptor_limit(std::uint64_t wanted);

}  // namespace talus::server
