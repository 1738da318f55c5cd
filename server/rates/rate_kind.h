// Which rate: those of config.h's Rates, in the same order.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace talus::server {

enum class RateKind : std::uint8_t {
  session_chunks,
  session_bytes,
  session_requests,
  address_chunks,
  address_bytes,
  address_requests
};
inline constexpr std::array<std::string_view, 6> kRateNames{"session_chunks",   "session_bytes",
                                                            "session_requests", "address_chunks",
                                                            "address_bytes",    "address_requests"};

}  // namespace talus::server
