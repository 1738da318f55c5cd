// Numbers that nobody guesses.
#pragma once

#include <cstdint>

namespace talus::server {

/// By the system's source of randomness.
[[nodiscard]] std::uint64_t random_number();

}  // namespace talus::server
