#include "config/access/signed_token.h"

#include <openssl/crypto.h>
#include <openssl/evp.h>
#include <openssl/hmac.h>
#include <strings.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <talus/protocol/limits.h>

#include "config/access/base64url.h"

namespace talus::server {
namespace {

using Json = nlohmann::json;
using std::chrono::seconds;
using std::chrono::sys_seconds;

/// Parts of an encoded token.
struct Parts {
  std::string_view header;
  std::string_view claims;
  std::string_view signature;
  std::string_view signed_text;  // header and claims
};

/// Returns nullopt unless the token has three non-empty parts.
std::optional<Parts> split(std::string_view token) {
  if (token.size() > protocol::kMaxStringBytes) return std::nullopt;
  const std::size_t first = token.find('.');
  const std::size_t second = token.rfind('.');
  if (first == std::string_view::npos || first == 0 || second < first + 2 || second + 1 == token.size()) {
    return std::nullopt;
  }
  const Parts parts{token.substr(0, first), token.substr(first + 1, second - first - 1),
                    token.substr(second + 1), token.substr(0, second)};
  return parts.claims.find('.') == std::string_view::npos ? std::optional{parts} : std::nullopt;
}

std::string signature_of(const Secret& key, std::string_view text) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int size = 0;
  ::HMAC(::EVP_sha256(), key.bytes().data(), static_cast<int>(key.bytes().size()),
         reinterpret_cast<const unsigned char*>(text.data()), text.size(), digest.data(), &size);
  return base64url_encode({reinterpret_cast<const char*>(digest.data()), size});
}

/// Compares the encoded texts, so that a signature has one spelling, in constant time.
bool same(std::string_view a, std::string_view b) {
  return a.size() == b.size() && ::CRYPTO_memcmp(a.data(), b.data(), a.size()) == 0;
}

/// Parses the JSON object in a part of a token. nullopt if it is not an object, or has a string with a zero
/// byte, which other programs would truncate. If a name is repeated, the last counts (RFC 7519 section 4).
/// The parser does not recurse, so a token's length bounds the cost of nesting.
std::optional<Json> parse_object(std::string_view part) {
  const auto text = base64url_decode(part);
  if (!text) return std::nullopt;
  bool sound = true;
  const auto check = [&](int, Json::parse_event_t, const Json& value) {
    const auto* string = value.get_ptr<const std::string*>();
    if (string != nullptr && string->find('\0') != std::string::npos) sound = false;
    return true;
  };
  auto json = Json::parse(*text, check, false);
  if (!sound || !json.is_object()) return std::nullopt;
  return json;
}

/// Returns the member; null if it is missing or has another type.
template <typename Value>
const Value* member(const Json& object, const char* name) {
  const auto found = object.find(name);
  return found == object.end() ? nullptr : found->get_ptr<const Value*>();
}

/// Parses a NumericDate (RFC 7519, section 2) and drops a fraction of a second; nullopt if the claim is
/// missing. An error is the reason.
tl::expected<std::optional<sys_seconds>, std::string> time_of(const Json& claims, const char* name) {
  const auto found = claims.find(name);
  if (found == claims.end()) return std::nullopt;
  if (!found->is_number()) {
    return tl::make_unexpected(fmt::format("its {} is not a number of seconds since 1970, but of type {}",
                                           name, found->type_name()));
  }
  constexpr double kEnd = 9223372036854775808.0;  // 2^63
  const double number = std::floor(found->get<double>());
  const bool is_integer = found->is_number_integer();
  if (is_integer ? found->is_number_unsigned() && found->get<std::uint64_t>() >= std::uint64_t{1} << 63
                 : !(number >= -kEnd && number < kEnd)) {
    return tl::make_unexpected(fmt::format("its {} is not a time in seconds since 1970", name));
  }
  return sys_seconds{seconds{is_integer ? found->get<std::int64_t>() : static_cast<std::int64_t>(number)}};
}

tl::unexpected<TokenError> foreign(std::string why) {
  return tl::make_unexpected(TokenError{false, false, std::move(why)});
}

tl::unexpected<TokenError> refused(std::string why) {
  return tl::make_unexpected(TokenError{true, false, std::move(why)});
}

/// Parses the boxes in a claim; nullopt if it is missing.
tl::expected<std::optional<Boxes>, std::string> boxes_of(const Json& claims, const char* name) {
  if (!claims.contains(name)) return std::nullopt;
  const auto* const text = member<std::string>(claims, name);
  if (text == nullptr) return tl::make_unexpected(fmt::format("its {} is not a string", name));
  auto boxes = Boxes::parse(*text);
  if (!boxes) return tl::make_unexpected(fmt::format("its {}: {}", name, boxes.error()));
  return *std::move(boxes);
}

/// Returns why the header is rejected; empty if it is accepted.
std::string header_error(std::string_view part) {
  const auto header = parse_object(part);
  if (!header) return "its header is not a JSON object";
  const auto* const algorithm = member<std::string>(*header, "alg");
  if (algorithm == nullptr || *algorithm != "HS256") return "it is not signed by HS256";
  const auto* const type = member<std::string>(*header, "typ");
  if (type != nullptr && ::strcasecmp(type->c_str(), "JWT") != 0) return "its type is not JWT";
  if (header->contains("crit")) return "its header asks for extensions";
  return {};
}

}  // namespace

tl::expected<Claims, TokenError> read_signed_token(const Secret& key, std::string_view token,
                                                   sys_seconds now) {
  const auto parts = split(token);
  if (!parts) return foreign("it is not a signed token");
  if (token.find_first_of("=+/ \t\r\n") != std::string_view::npos) {
    return foreign("it has padding (=), a blank or other characters that base64url does not have");
  }
  if (!same(signature_of(key, parts->signed_text), parts->signature)) {
    return foreign("its signature does not match this server's key, or it is not a signed token");
  }
  if (auto error = header_error(parts->header); !error.empty()) return refused(std::move(error));
  const auto json = parse_object(parts->claims);
  if (!json) return refused("its claims are not a JSON object");

  const auto expiry = time_of(*json, "exp");
  if (!expiry) return refused(expiry.error());
  if (!*expiry) return refused("it has no exp");
  const sys_seconds expires = **expiry;
  const auto not_before = time_of(*json, "nbf");
  if (!not_before) return refused(not_before.error());
  const auto* const subject = member<std::string>(*json, "sub");
  const auto* const words = member<std::string>(*json, "rights");
  if (expires < sys_seconds{}) return refused("its exp is before 1970");
  if (subject == nullptr && json->contains("sub")) return refused("its sub is not a string");
  const auto* const id = member<std::string>(*json, "jti");
  if (id == nullptr && json->contains("jti")) return refused("its jti is not a string");
  if (words == nullptr && json->contains("rights")) {
    return refused(R"(its rights are not a string such as "read,edit")");
  }
  if (now - kClockSkew >= expires) {
    return tl::make_unexpected(
        TokenError{true, true, fmt::format("it expired {} s ago", (now - expires).count())});
  }
  if (*not_before && now + kClockSkew < **not_before) {
    return refused(fmt::format("it is not valid yet, for {} s: nbf", (**not_before - now).count()));
  }

  Claims claims{subject == nullptr ? "" : *subject,
                {Right::read},
                expires,
                id == nullptr ? "" : *id,
                time_of(*json, "iat").value_or(std::nullopt)};
  if (words != nullptr) {
    const auto rights = Rights::parse(*words);
    if (!rights) return refused(fmt::format("its rights: {}", rights.error()));
    if (!rights->has(Right::read)) return refused("its rights lack read");
    claims.rights = *rights;
  }
  auto edit_in = boxes_of(*json, "edit_in");
  if (!edit_in) return refused(std::move(edit_in.error()));
  auto edit_not_in = boxes_of(*json, "edit_not_in");
  if (!edit_not_in) return refused(std::move(edit_not_in.error()));
  claims.edit_in = *std::move(edit_in);
  if (*edit_not_in) claims.edit_not_in = **std::move(edit_not_in);
  return claims;
}

tl::expected<std::string, std::string> make_signed_token(const Secret& key, const Claims& claims,
                                                         sys_seconds now) {
  Json json{{"sub", claims.subject},
            {"rights", to_string(claims.rights)},
            {"iat", now.time_since_epoch().count()},
            {"exp", claims.expires.time_since_epoch().count()}};
  if (!claims.id.empty()) json["jti"] = claims.id;
  if (claims.edit_in) json["edit_in"] = claims.edit_in->text();
  if (!claims.edit_not_in.empty()) json["edit_not_in"] = claims.edit_not_in.text();
  std::string text;
  try {
    text = json.dump();
  } catch (const Json::type_error&) {
    return tl::make_unexpected(std::string{"the subject is not UTF-8"});
  }
  std::string token = base64url_encode(R"({"alg":"HS256","typ":"JWT"})") + "." + base64url_encode(text);
  token += "." + signature_of(key, token);
  if (token.size() > protocol::kMaxStringBytes) {
    return tl::make_unexpected(fmt::format(
        "the token would have {} bytes, over the protocol's {}; shorten the subject, or give fewer boxes",
        token.size(), protocol::kMaxStringBytes));
  }
  return token;
}

}  // namespace talus::server
