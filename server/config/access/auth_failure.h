// Why a client is not authenticated, or not served any more.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace talus::server {

/// A client is told no more than this.
enum class AuthFailure : std::uint8_t { missing, expired, not_accepted, revoked, blocked };
inline constexpr std::array<std::string_view, 5> kAuthFailureNames{"missing", "expired", "not_accepted",
                                                                   "revoked", "blocked"};

/// The sentence that the client gets.
[[nodiscard]] std::string_view describe(AuthFailure failure);

}  // namespace talus::server
