// Why a client is not authenticated.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace talus::server {

/// A client is told no more than this.
enum class AuthFailure : std::uint8_t { missing, expired, not_accepted, revoked };
inline constexpr std::array<std::string_view, 4> kAuthFailureNames{"missing", "expired", "not_accepted",
                                                                   "revoked"};

/// The sentence that the client gets.
[[nodiscard]] std::string_view describe(AuthFailure failure);

}  // namespace talus::server
