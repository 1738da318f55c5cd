// How many files and sockets the system lets this process hold.
#pragma once

#include <cstddef>
#include <cstdint>

namespace talus::server {

/// The highest numbers that the limit allows are no client's to keep: they are for operators, for files that
/// are read again, and for telling clients that there are no more.
inline constexpr std::uint64_t kSpareDescriptors = 16;
/// Whether `descriptor` is one of them now. The system gives the lowest free number, so as long as clients
/// keep none, whatever they do leaves so many to the others.
[[nodiscard]] bool is_spare(int descriptor);

/// What a server of so many sockets and io_contexts needs, its listening sockets, files and spare ones
/// included.
[[nodiscard]] std::uint64_t descriptors_needed(std::uint64_t sockets, std::size_t io_contexts);

/// Sets the process's own limit of open files to `wanted`, or to what the system allows it if that is less;
/// returns what it is now.
[[nodiscard]] std::uint64_t set_descriptor_limit(std::uint64_t wanted);
/// The same, but never lowers it: while clients are served they may hold all numbers below a lower limit, and
/// then nothing could be opened, not for operators either.
[[nodiscard]] std::uint64_t raise_descriptor_limit(std::uint64_t wanted);

}  // namespace talus::server
