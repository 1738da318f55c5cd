// How many files and sockets the system lets this process hold.
#pragma once

#include <cstddef>
#include <cstdint>

namespace talus::server {

/// What a server of so many connections and io threads needs, its own listening sockets and files included.
[[nodiscard]] std::uint64_t descriptors_needed(std::uint64_t connections, std::size_t io_threads);

/// Sets the process's own limit of open files to `wanted`, or to what the system allows it if that is less;
/// returns what it is now.
[[nodiscard]] std::uint64_t set_descriptor_limit(std::uint64_t wanted);

}  // namespace talus::server
