#include "config/access/access_control.h"

#include <openssl/crypto.h>
#include <openssl/sha.h>

#include <utility>

#include <fmt/format.h>

#include "config/access/signed_token.h"

namespace talus::server {
namespace {

/// Length of the shared secret: shorter ones can be guessed, longer ones do not fit into a Hello.
constexpr KeyBounds kSecretBounds{16, 1024};

SecretDigest digest_of(std::string_view text) {
  SecretDigest digest{};
  ::SHA256(reinterpret_cast<const unsigned char*>(text.data()), text.size(), digest.data());
  return digest;
}

/// Compares in constant time.
bool same(const SecretDigest& a, const SecretDigest& b) {
  return ::CRYPTO_memcmp(a.data(), b.data(), a.size()) == 0;
}

/// The words were validated with the configuration.
Rights rights_of(std::string_view words) {
  return Rights::parse(words).value_or(Rights{});
}

Rights without_token(const Access& settings, const TokenKeys& keys) {
  if (settings.without_token != "auto") return rights_of(settings.without_token);
  return keys.any() ? Rights{} : Rights{Right::read};
}

/// Reads the key file if the setting names one, and appends its warning.
tl::expected<std::optional<Secret>, std::string> load(std::string_view setting,
                                                      const std::filesystem::path& file, KeyBounds bounds,
                                                      std::vector<std::string>& warnings) {
  if (file.empty()) return std::optional<Secret>{};
  auto read = read_key_file(file, bounds);
  if (!read) return tl::make_unexpected(fmt::format("{} {}", setting, read.error()));
  if (read->warning) warnings.push_back(fmt::format("{} {}", setting, *read->warning));
  return std::optional<Secret>{std::move(read->secret)};
}

/// A part that is reread while others still use the old value.
template <class Part>
using PartOrError = tl::expected<std::shared_ptr<const Part>, std::string>;

PartOrError<TokenKeys> read_token_keys(const Access& settings) {
  TokenKeys keys;
  const auto secret = load("access.secret_file", settings.secret_file, kSecretBounds, keys.warnings);
  if (!secret) return tl::make_unexpected(secret.error());
  if (*secret) keys.shared_secret = digest_of((*secret)->bytes());
  for (const auto& [setting, file] :
       {std::pair{"access.signing_key_file", &settings.signing_key_file},
        std::pair{"access.previous_signing_key_file", &settings.previous_signing_key_file}}) {
    auto signing = load(setting, *file, kSigningKeyBounds, keys.warnings);
    if (!signing) return tl::make_unexpected(signing.error());
    if (*signing) keys.signing_keys.push_back(*std::move(*signing));
  }
  return std::make_shared<const TokenKeys>(std::move(keys));
}

PartOrError<RevokedTokens> read_revoked(const Access& settings) {
  if (settings.revoked_file.empty()) return std::make_shared<const RevokedTokens>();
  if (settings.signing_key_file.empty() && settings.previous_signing_key_file.empty()) {
    return tl::make_unexpected(
        std::string{"access.revoked_file: without access.signing_key_file there are no tokens to revoke; set "
                    "that, or leave this empty"});
  }
  auto read = RevokedTokens::read(settings.revoked_file);
  if (!read) return tl::make_unexpected(fmt::format("access.revoked_file {}", read.error()));
  return std::make_shared<const RevokedTokens>(*std::move(read));
}

PartOrError<BlockedFlows> read_blocked(const Access& settings) {
  if (settings.blocked_file.empty()) return std::make_shared<const BlockedFlows>();
  auto read = BlockedFlows::read(settings.blocked_file);
  if (!read) return tl::make_unexpected(fmt::format("access.blocked_file {}", read.error()));
  return std::make_shared<const BlockedFlows>(*std::move(read));
}

/// Stores the new part, or appends the reason why the old one stays.
template <class Part>
void take_part(PartOrError<Part> read, std::shared_ptr<const Part>& place, std::string_view stays,
               std::vector<std::string>& failures) {
  if (read) {
    place = *std::move(read);
  } else {
    failures.push_back(fmt::format("{}; {}", read.error(), stays));
  }
}

}  // namespace

tl::expected<Keys, std::string> load_keys(const Access& settings) {
  auto tokens = read_token_keys(settings);
  if (!tokens) return tl::make_unexpected(std::move(tokens.error()));
  auto revoked = read_revoked(settings);
  if (!revoked) return tl::make_unexpected(std::move(revoked.error()));
  auto blocked = read_blocked(settings);
  if (!blocked) return tl::make_unexpected(std::move(blocked.error()));
  Keys keys{*std::move(tokens), *std::move(revoked), *std::move(blocked)};
  keys.warnings = keys.tokens->warnings;
  if (without_token(settings, *keys.tokens) == Rights{} && !keys.any()) {
    return tl::make_unexpected(
        std::string{"access.without_token: \"none\" without access.secret_file or access.signing_key_file "
                    "rejects every client; set one of them, or \"read\""});
  }
  return keys;
}

std::string_view describe(AuthFailure failure) {
  switch (failure) {
    case AuthFailure::missing:
      return "this server asks for a token";
    case AuthFailure::expired:
      return "the token has expired";
    case AuthFailure::revoked:
      return "the token was revoked";
    case AuthFailure::blocked:
      return "this server's operator has blocked you";
    case AuthFailure::not_accepted:
      break;
  }
  return "the token is not accepted";
}

std::string AuthError::text() const {
  std::string sentence{describe(failure)};
  if (failure == AuthFailure::not_accepted && signed_by_key) sentence += ": " + reason;
  return sentence;
}

AccessControl::AccessControl(const Access& settings, Keys keys)
    : settings_{settings},
      secret_rights_{rights_of(settings.secret_rights)},
      keys_{std::make_shared<const Keys>(std::move(keys))},
      anybody_reads_{without_token(settings, *keys_->tokens).has(Right::read)} {}

tl::expected<Grant, AuthError> AccessControl::admit(std::string_view token,
                                                    std::chrono::sys_seconds now) const {
  const std::shared_ptr<const Keys> known = keys();
  if (token.empty() || !known->any()) {
    const Rights rights = without_token(settings_, *known->tokens);
    if (rights == Rights{}) return tl::make_unexpected(AuthError{AuthFailure::missing, {}});
    return Grant{rights, {}, {}};
  }
  if (known->tokens->shared_secret && same(digest_of(token), *known->tokens->shared_secret))
    return Grant{secret_rights_, {}, {}};
  AuthError error{AuthFailure::not_accepted, "it is not the shared secret"};
  for (const Secret& key : known->tokens->signing_keys) {
    auto claims = read_signed_token(key, token, now);
    if (claims) {
      if (known->revoked->contains(claims->id, claims->subject, claims->issued)) {
        return tl::make_unexpected(AuthError{AuthFailure::revoked, {}});
      }
      if (const auto* const line = known->blocked->find_subject(claims->subject)) {
        return tl::make_unexpected(AuthError{AuthFailure::blocked,
                                             fmt::format("line {} of access.blocked_file", line->number()),
                                             !line->meet()});
      }
      return Grant{claims->rights,
                   std::move(claims->subject),
                   claims->expires,
                   std::move(claims->id),
                   claims->issued,
                   std::move(claims->edit_in),
                   std::move(claims->edit_not_in)};
    }
    error = {claims.error().expired ? AuthFailure::expired : AuthFailure::not_accepted,
             std::move(claims.error().reason), false, claims.error().signed_by_key};
    if (claims.error().signed_by_key) break;  // no other key can give a better reason
  }
  return tl::make_unexpected(std::move(error));
}

tl::expected<std::string, std::string> AccessControl::reload(const Access& settings) {
  settings_.revoked_file = settings.revoked_file;
  settings_.blocked_file = settings.blocked_file;
  auto fresh = std::make_shared<Keys>(*keys());
  std::vector<std::string> failures;
  take_part(read_token_keys(settings_), fresh->tokens, "the old keys stay in use", failures);
  take_part(read_revoked(settings_), fresh->revoked, "the old list stays in use", failures);
  take_part(read_blocked(settings_), fresh->blocked, "the old list stays in use", failures);
  const TokenKeys& tokens = *fresh->tokens;
  std::string line = tokens.any() ? "the tokens' keys were read again" : "no token keys are configured";
  if (!settings_.revoked_file.empty())
    line += fmt::format(", {} lines of revoked tokens", fresh->revoked->size());
  if (!settings_.blocked_file.empty())
    line += fmt::format(", {} lines of blocked flows", fresh->blocked->size());
  if (!tokens.warnings.empty()) line += fmt::format("; {}", fmt::join(tokens.warnings, "; "));
  {
    const std::lock_guard lock{mutex_};
    anybody_reads_ = without_token(settings_, tokens).has(Right::read);
    keys_ = std::move(fresh);
  }
  if (!failures.empty()) return tl::make_unexpected(fmt::format("{}", fmt::join(failures, "; ")));
  return line;
}

std::optional<AuthFailure> AccessControl::withdrawn(const Grant& grant) const {
  if (!grant.expires) return std::nullopt;  // not a signed token
  const std::shared_ptr<const Keys> known = keys();
  if (known->revoked->contains(grant.token_id, grant.subject, grant.issued)) return AuthFailure::revoked;
  if (known->blocked->find_subject(grant.subject) != nullptr) return AuthFailure::blocked;
  return std::nullopt;
}

std::optional<BlockedAddress> AccessControl::meet(const asio::ip::address& address) const {
  const std::shared_ptr<const Keys> known = keys();
  const auto* const line = known->blocked->find(address);
  if (line == nullptr) return std::nullopt;
  return BlockedAddress{line->number(), !line->meet()};
}

bool AccessControl::blocks(const asio::ip::address& address) const {
  return keys()->blocked->find(address) != nullptr;
}

std::shared_ptr<const Keys> AccessControl::keys() const {
  const std::lock_guard lock{mutex_};
  return keys_;
}

}  // namespace talus::server
