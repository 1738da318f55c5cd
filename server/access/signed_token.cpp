#include "access/signed_token.h"

#include <jwt.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>
#include <system_error>

#include <fmt/format.h>

#include <talus/protocol/limits.h>

namespace talus::server {
namespace {

using std::chrono::seconds;
using std::chrono::sys_seconds;

using Jwt = std::unique_ptr<jwt_t, decltype(&jwt_free)>;
using Json = std::unique_ptr<char, decltype(&std::free)>;

const unsigned char* data_of(const Secret& key) {
  return reinterpret_cast<const unsigned char*>(key.bytes().data());
}
int size_of(const Secret& key) {
  return static_cast<int>(key.bytes().size());
}

/// Three parts, none empty: libjwt 1.10 writes a byte into the no bytes that an empty one decodes to. And of
/// the alphabet alone: libjwt passes over all else, so that one token would have many spellings.
bool spelled_like_one(std::string_view token) {
  const auto in_alphabet = [](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.';
  };
  return token.size() <= protocol::kMaxStringBytes && std::all_of(token.begin(), token.end(), in_alphabet) &&
         std::count(token.begin(), token.end(), '.') == 2 && !token.starts_with('.') &&
         !token.ends_with('.') && token.find("..") == std::string_view::npos;
}

/// The claim as JSON; null where it is missing. Of a claim of another type than asked for, libjwt makes a 0.
Json claim(jwt_t* jwt, const char* name) {
  return {jwt_get_grants_json(jwt, name), &std::free};
}

/// None where the claim is no whole number, or missing.
std::optional<sys_seconds> time_of(jwt_t* jwt, const char* name) {
  const Json json = claim(jwt, name);
  const std::string_view text = json == nullptr ? std::string_view{} : json.get();
  std::int64_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc{} || stop != text.data() + text.size()) return std::nullopt;
  return sys_seconds{seconds{value}};
}

tl::unexpected<TokenFault> foreign(std::string why) {
  return tl::make_unexpected(TokenFault{false, false, std::move(why)});
}

tl::unexpected<TokenFault> refused(std::string why) {
  return tl::make_unexpected(TokenFault{true, false, std::move(why)});
}

}  // namespace

tl::expected<Claims, TokenFault> read_signed_token(const Secret& key, std::string_view token,
                                                   sys_seconds now) {
  if (!spelled_like_one(token)) return foreign("it is no signed token");
  jwt_t* decoded = nullptr;
  if (jwt_decode(&decoded, std::string{token}.c_str(), data_of(key), size_of(key)) != 0) {
    return foreign("its signature is not of this server's key, or it is no signed token");
  }
  const Jwt jwt{decoded, &jwt_free};
  if (jwt_get_alg(jwt.get()) != JWT_ALG_HS256) return refused("it is not signed by HS256");
  if (Json{jwt_get_headers_json(jwt.get(), "crit"), &std::free} != nullptr)
    return refused("its header asks for extensions");

  const auto expires = time_of(jwt.get(), "exp");
  const auto not_before = time_of(jwt.get(), "nbf");
  const char* const subject = jwt_get_grant(jwt.get(), "sub");
  const char* const words = jwt_get_grant(jwt.get(), "rights");
  if (!expires || *expires < sys_seconds{}) return refused("its exp is missing or no whole number from 0 on");
  if (!not_before && claim(jwt.get(), "nbf") != nullptr) return refused("its nbf is no whole number");
  if (subject == nullptr && claim(jwt.get(), "sub") != nullptr) return refused("its sub is no text");
  if (words == nullptr && claim(jwt.get(), "rights") != nullptr) return refused("its rights are no text");
  if (now - kClockSkew >= *expires) {
    return tl::make_unexpected(
        TokenFault{true, true, fmt::format("it expired {} s ago", (now - *expires).count())});
  }
  if (not_before && now + kClockSkew < *not_before) return refused("its time has not come: nbf");

  Claims claims{subject == nullptr ? "" : subject, {Right::read}, *expires};
  if (words != nullptr) {
    const auto rights = Rights::parse(words);
    if (!rights || !rights->has(Right::read))
      return refused("its rights are not of read, edit, admin, with read among them");
    claims.rights = *rights;
  }
  return claims;
}

tl::expected<std::string, std::string> make_signed_token(const Secret& key, const Claims& claims,
                                                         sys_seconds now) {
  jwt_t* made = nullptr;
  if (jwt_new(&made) != 0) return tl::make_unexpected(std::string{"out of memory"});
  const Jwt jwt{made, &jwt_free};
  const auto time = [](sys_seconds at) { return static_cast<long>(at.time_since_epoch().count()); };
  // Text that is not UTF-8 is refused here.
  const bool done = jwt_set_alg(made, JWT_ALG_HS256, data_of(key), size_of(key)) == 0 &&
                    jwt_add_grant(made, "sub", claims.subject.c_str()) == 0 &&
                    jwt_add_grant(made, "rights", to_string(claims.rights).c_str()) == 0 &&
                    jwt_add_grant_int(made, "iat", time(now)) == 0 &&
                    jwt_add_grant_int(made, "exp", time(claims.expires)) == 0;
  const Json text{done ? jwt_encode_str(made) : nullptr, &std::free};
  if (text == nullptr) {
    return tl::make_unexpected(std::string{"the token cannot be made; is the subject UTF-8?"});
  }
  std::string token{text.get()};
  if (token.size() > protocol::kMaxStringBytes) {
    return tl::make_unexpected(
        fmt::format("the token would have {} bytes, over the protocol's {}; shorten the subject",
                    token.size(), protocol::kMaxStringBytes));
  }
  return token;
}

}  // namespace talus::server
