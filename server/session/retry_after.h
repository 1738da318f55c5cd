// When a client that was refused may try again: what retry_after_ms says.
#pragma once

#include <chrono>

namespace talus::server::retry_after {

/// The server has no place for a connection.
inline constexpr std::chrono::milliseconds kServerFull{5000};
/// The server ends; another one may take its address.
inline constexpr std::chrono::milliseconds kServerEnds{5000};

}  // namespace talus::server::retry_after
