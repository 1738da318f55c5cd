// Unpredictable random numbers.
#pragma once

#include <cstdint>

namespace talus::server {

/// Uses the system's source of randomness.
[[nodiscard]] std::uint64_t random_number();

}  // namespace talus::server
