// Limits of the open files and sockets of this process.
#pragma once

#include <cstddef>
#include <cstdint>

namespace talus::server {

/// The highest 16 descriptor numbers that the limit allows are reserved and never kept by a client: they
/// serve operators, files that are read again, and messages that refuse clients for lack of descriptors.
inline constexpr std::uint64_t kSpareDescriptors = 16;
/// Returns true if `descriptor` is reserved under the current limit. The system assigns the lowest free
/// number, so if clients keep no reserved numbers, 16 remain whatever they do.
[[nodiscard]] bool is_spare(int descriptor);

/// Minimum number of open files of a server without clients.
inline constexpr std::uint64_t kMinDescriptors = 64;

/// Descriptors needed by a server with `sockets` sockets and `io_contexts` contexts, including listening
/// sockets, files and the reserved ones.
[[nodiscard]] std::uint64_t descriptors_needed(std::uint64_t sockets, std::size_t io_contexts);

/// Sets the process's soft limit of open files to `wanted`, or to the hard limit if that is less. Returns the
/// new limit.
[[nodiscard]] std::uint64_t set_descriptor_limit(std::uint64_t wanted);
/// As set_descriptor_limit(), but never lowers the limit: clients being served may hold every number below a
/// lower one, and then nothing could be opened, even for operators.
[[nodiscard]] std::uint64_t raise_descriptor_limit(std::uint64_t wanted);

}  // namespace talus::server
