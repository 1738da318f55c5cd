// Signed tokens as tests make and read them, all with one key and at one time.
#pragma once

#include <chrono>
#include <string>

#include <catch2/catch.hpp>

#include "config/access/signed_token.h"

namespace talus::server {

inline const std::string kKeyText = "0123456789abcdef0123456789abcdef";
inline constexpr std::chrono::sys_seconds kNow{std::chrono::seconds{1'800'000'000}};

[[nodiscard]] inline std::string token(const Claims& claims, const std::string& key = kKeyText) {
  return *make_signed_token(Secret{key}, claims, kNow);
}

[[nodiscard]] inline tl::expected<Claims, TokenError> read(const std::string& text,
                                                           std::chrono::sys_seconds now = kNow) {
  return read_signed_token(Secret{kKeyText}, text, now);
}

}  // namespace talus::server
