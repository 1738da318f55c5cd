// Why a token gives nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace talus::server {

/// Clients are told no more than this.
enum class Denial : std::uint8_t { missing, expired, not_accepted };
inline constexpr std::size_t kDenials = 3;

[[nodiscard]] std::string_view describe(Denial denial);

}  // namespace talus::server
