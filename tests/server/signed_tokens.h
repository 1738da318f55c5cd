// Signed tokens as tests make and read them, all with one key and at one time.
#pragma once

#include <openssl/evp.h>
#include <openssl/hmac.h>

#include <array>
#include <chrono>
#include <string>

#include <catch2/catch.hpp>

#include "config/access/base64url.h"
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

inline const std::string kHs256 = R"({"alg":"HS256","typ":"JWT"})";

/// A token of this header and these claims, signed by the server's key and `digest`.
[[nodiscard]] inline std::string raw_token(const std::string& header, const std::string& claims,
                                           const EVP_MD* digest = EVP_sha256()) {
  const std::string text = base64url_encode(header) + "." + base64url_encode(claims);
  std::array<unsigned char, EVP_MAX_MD_SIZE> signature{};
  unsigned int size = 0;
  REQUIRE(HMAC(digest, kKeyText.data(), static_cast<int>(kKeyText.size()),
               reinterpret_cast<const unsigned char*>(text.data()), text.size(), signature.data(),
               &size) != nullptr);
  return text + "." + base64url_encode({reinterpret_cast<const char*>(signature.data()), size});
}

}  // namespace talus::server
