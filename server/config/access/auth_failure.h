// Reasons for rejecting a client or ending its session.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace talus::server {

/// Clients learn no more than this, unless a token is signed by this server's key.
enum class AuthFailure : std::uint8_t { missing, expired, not_accepted, revoked, blocked };
inline constexpr std::array<std::string_view, 5> kAuthFailureNames{"missing", "expired", "not_accepted",
                                                                   "revoked", "blocked"};

/// Sentence sent to the client.
[[nodiscard]] std::string_view describe(AuthFailure failure);

}  // namespace talus::server
