// Key files, tokens, rights, and reloads.
#include "access/access_control.h"

#include <openssl/evp.h>
#include <openssl/hmac.h>
#include <rapidcheck.h>
#include <sys/stat.h>

#include <array>
#include <catch2/catch.hpp>
#include <memory>

#include "access/base64url.h"
#include "access/signed_token.h"
#include "access/token_command.h"
#include "scratch_directory.h"

using namespace talus::server;
using namespace std::chrono_literals;
using std::chrono::sys_seconds;

namespace {

const std::string kSecretText = "correct horse battery staple";
const std::string kKeyText = "0123456789abcdef0123456789abcdef";
constexpr sys_seconds kNow{1'800'000'000s};

/// Key files with both kinds of keys.
struct Files {
  ScratchDirectory scratch;
  Access settings{scratch.write("secret", kSecretText + "\n"), "read,edit",
                  scratch.write("key", kKeyText + "\n"), "auto"};
};

AccessControl control_of(const Access& settings) {
  auto keys = load_keys(settings);
  REQUIRE(keys.has_value());
  return {settings, *std::move(keys)};
}

std::string load_error(const Access& settings) {
  const auto keys = load_keys(settings);
  REQUIRE_FALSE(keys.has_value());
  CHECK(keys.error().find('\n') == std::string::npos);
  return keys.error();
}

AuthError denied(const tl::expected<Grant, AuthError>& answer) {
  REQUIRE_FALSE(answer.has_value());
  return answer.error();
}

std::string token(const Claims& claims, const std::string& key = kKeyText) {
  return *make_signed_token(Secret{key}, claims, kNow);
}

/// A token of this header and these claims, signed by the server's key and `digest`.
std::string raw_token(const std::string& header, const std::string& claims,
                      const EVP_MD* digest = EVP_sha256()) {
  const std::string text = base64url_encode(header) + "." + base64url_encode(claims);
  std::array<unsigned char, EVP_MAX_MD_SIZE> signature{};
  unsigned int size = 0;
  REQUIRE(HMAC(digest, kKeyText.data(), static_cast<int>(kKeyText.size()),
               reinterpret_cast<const unsigned char*>(text.data()), text.size(), signature.data(),
               &size) != nullptr);
  return text + "." + base64url_encode({reinterpret_cast<const char*>(signature.data()), size});
}

const std::string kHs256 = R"({"alg":"HS256","typ":"JWT"})";
const std::string kGoodClaims = R"({"exp": 1800009999})";

tl::expected<Claims, TokenError> read(const std::string& text, sys_seconds now = kNow) {
  return read_signed_token(Secret{kKeyText}, text, now);
}

tl::expected<std::string, Exit> command(std::vector<const char*> words) {
  words.insert(words.begin(), "token");
  return token_command(static_cast<int>(words.size()), words.data(), kNow);
}

}  // namespace

TEST_CASE("without keys every client may read, whatever token it sends") {
  const AccessControl access = control_of({});
  for (const char* shown : {"", "anything"}) {
    const auto grant = access.admit(shown, kNow);
    REQUIRE(grant.has_value());
    CHECK(grant->rights == Rights{Right::read});
  }
}

TEST_CASE("with a key a client without a token is refused, unless the configuration gives it rights") {
  Files files;
  CHECK(denied(control_of(files.settings).admit("", kNow)).failure == AuthFailure::missing);
  files.settings.without_token = "read";
  const AccessControl access = control_of(files.settings);
  CHECK(access.admit("", kNow)->rights == Rights{Right::read});
  CHECK(denied(access.admit("wrong", kNow)).failure == AuthFailure::not_accepted);
}

TEST_CASE("the shared secret gives the rights that the configuration says, and nothing near it does") {
  const Files files;
  const AccessControl access = control_of(files.settings);
  const auto grant = access.admit(kSecretText, kNow);
  REQUIRE(grant.has_value());
  CHECK(grant->rights == Rights{Right::read, Right::edit});
  CHECK_FALSE(grant->expires.has_value());
  for (const std::string& near : {kSecretText + "\n", kSecretText + " ", kSecretText.substr(1),
                                  kSecretText.substr(0, kSecretText.size() - 1), std::string{"x"}}) {
    CAPTURE(near);
    CHECK(denied(access.admit(near, kNow)).failure == AuthFailure::not_accepted);
  }
}

TEST_CASE("a signed token gives its own rights, its subject and its expiry") {
  const Files files;
  const auto grant =
      control_of(files.settings).admit(token({"alice", {Right::read, Right::admin}, kNow + 1h}), kNow);
  REQUIRE(grant.has_value());
  CHECK(grant->rights == Rights{Right::read, Right::admin});
  CHECK(grant->subject == "alice");
  CHECK(grant->expires == kNow + 1h);
}

TEST_CASE("a token is accepted until 30 seconds after exp, and then has expired") {
  const std::string text = token({"a", {Right::read}, kNow});
  CHECK(read(text, kNow + kClockSkew - 1s).has_value());
  const auto late = read(text, kNow + kClockSkew);
  REQUIRE_FALSE(late.has_value());
  CHECK(late.error().expired);
}

TEST_CASE("a token is accepted from 30 seconds before nbf, and is not expired before that") {
  const std::string text = raw_token(kHs256, R"({"exp": 1800009999, "nbf": 1800000000})");
  CHECK(read(text, kNow - kClockSkew).has_value());
  const auto early = read(text, kNow - kClockSkew - 1s);
  REQUIRE_FALSE(early.has_value());
  CHECK_FALSE(early.error().expired);
}

TEST_CASE("an expired token of another key is not accepted, and not called expired") {
  const auto answer = read(token({"a", {Right::read}, kNow - 1h}, kKeyText + "x"));
  REQUIRE_FALSE(answer.has_value());
  CHECK_FALSE(answer.error().expired);
}

TEST_CASE("the example of RFC 7515, appendix A.1, is read") {
  const auto key = base64url_decode(
      "AyM1SysPpbyDfgZld3umj1qzKObwVMkoqQ-EstJQLr_T-1qS0gZH75aKtMN3Yj0iPS4hcgUuTwjAzZr1Z9CAow");
  REQUIRE(key.has_value());
  const auto claims = read_signed_token(
      Secret{*key},
      "eyJ0eXAiOiJKV1QiLA0KICJhbGciOiJIUzI1NiJ9"
      ".eyJpc3MiOiJqb2UiLA0KICJleHAiOjEzMDA4MTkzODAsDQogImh0dHA6Ly9leGFtcGxlLmNvbS9pc19yb290Ijp0cnVlfQ"
      ".dBjftJeZ4CVP-mB92K27uhbUJU1p1r_wW1gFWFOEjXk",
      sys_seconds{1'300'819'000s});
  REQUIRE(claims.has_value());
  CHECK(claims->expires == sys_seconds{1'300'819'380s});
  CHECK(claims->rights == Rights{Right::read});
}

TEST_CASE("no algorithm but HS256 is accepted, though the key would fit") {
  CHECK(read(raw_token(kHs256, kGoodClaims)).has_value());
  CHECK_FALSE(read(raw_token(R"({"alg":"HS384"})", kGoodClaims, EVP_sha384())).has_value());
  CHECK_FALSE(read(raw_token(R"({"alg":"HS512"})", kGoodClaims, EVP_sha512())).has_value());
  for (const char* header : {R"({"alg":"none"})", R"({"alg":"HS384"})", R"({"alg":"RS256"})",
                             R"({"alg":"hs256"})", R"({"alg":7})", R"({})", "[]", "", "HS256"}) {
    CAPTURE(header);
    const auto signed_otherwise = read(raw_token(header, kGoodClaims));
    REQUIRE_FALSE(signed_otherwise.has_value());
  }
}

TEST_CASE("the type of a token is JWT, in any case, or missing") {
  for (const char* header : {R"({"alg":"HS256"})", R"({"alg":"HS256","typ":"jwt"})"}) {
    CHECK(read(raw_token(header, kGoodClaims)).has_value());
  }
  CHECK_FALSE(read(raw_token(R"({"alg":"HS256","typ":"at+jwt"})", kGoodClaims)).has_value());
}

TEST_CASE("of a claim that appears twice the last counts") {
  CHECK(read(raw_token(kHs256, R"({"exp": 5, "exp": 1800009999})"))->expires == sys_seconds{1'800'009'999s});
  CHECK_FALSE(read(raw_token(kHs256, R"({"exp": 1800009999, "exp": 5})")).has_value());
}

TEST_CASE("deeply nested claims do not overflow the stack") {
  const auto nested = [](std::size_t depth) {
    return raw_token(kHs256,
                     R"({"exp":1800009999,"x":)" + std::string(depth, '[') + std::string(depth, ']') + "}");
  };
  CHECK(read(nested(1000)).has_value());
  // As deep as the longest token can be.
  const std::string deepest = raw_token(kHs256, R"({"exp":1,"x":)" + std::string(2900, '['));
  REQUIRE(deepest.size() < 4096);
  CHECK_FALSE(read(deepest).has_value());
}

TEST_CASE("an unsigned token, and one signed by nothing of use, are not accepted") {
  // {"alg":"none"} and {"alg":"RS256"} before {"exp":1800009999}, signed by nothing of use.
  const std::string body = "eyJleHAiOjE4MDAwMDk5OTl9";
  for (const std::string header : {"eyJhbGciOiJub25lIn0", "eyJhbGciOiJSUzI1NiJ9"}) {
    for (const std::string signature : {"", "c2lnbmF0dXJl"}) {
      CHECK_FALSE(read(header + "." + body + "." + signature).has_value());
    }
  }
}

TEST_CASE("claims and headers of a wrong type or value are not accepted") {
  for (const char* claims : {R"({})",
                             R"([])",
                             R"(5)",
                             "",
                             R"({"exp": "1800009999"})",
                             R"({"exp": 1800009999.0})",
                             R"({"exp": 1.8e9})",
                             R"({"exp": true})",
                             R"({"exp": null})",
                             R"({"exp": -1})",
                             R"({"exp": -9223372036854775808})",
                             R"({"exp": 9223372036854775808})",
                             R"({"exp": 99999999999999999999})",
                             R"({"exp": 1800009999} x)",
                             R"({"exp": 1800009999,})",
                             R"({"exp": 1800009999, "nbf": "now"})",
                             R"({"exp": 1800009999, "nbf": null})",
                             R"({"exp": 1800009999, "nbf": 9223372036854775807})",
                             R"({"exp": 1800009999, "sub": 7})",
                             R"({"exp": 1800009999, "sub": "a\u0000b"})",
                             "{\"exp\": 1800009999, \"sub\": \"\xff\"}",
                             R"({"exp": 1800009999, "rights": ["read"]})",
                             R"({"exp": 1800009999, "rights": "none"})",
                             R"({"exp": 1800009999, "rights": "edit"})",
                             R"({"exp": 1800009999, "rights": "read,fly"})"}) {
    CAPTURE(claims);
    const auto claimed = read(raw_token(kHs256, claims));
    REQUIRE_FALSE(claimed.has_value());
    CHECK_FALSE(claimed.error().expired);
    CHECK(claimed.error().signed_by_key == !std::string{claims}.empty());
  }
  CHECK_FALSE(read(raw_token(R"({"alg":"HS256","crit":["b64"]})", kGoodClaims)).has_value());
  CHECK(read(raw_token(kHs256, R"({"exp": 9223372036854775807})")).has_value());
}

TEST_CASE("base64url is that of RFC 4648, without padding") {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kExamples{
      {{"", ""}, {"f", "Zg"}, {"fo", "Zm8"}, {"foo", "Zm9v"}, {"\xfb\xef\xff", "--__"}}};
  for (const auto& [bytes, text] : kExamples) {
    CHECK(base64url_encode(bytes) == text);
    CHECK(base64url_decode(text) == bytes);
  }
  for (const char* text : {"Z", "Zm9vZ", "Zg==", "Zm+v", "Zm/v", "Zm 9", "Zm9v\n"}) {
    CAPTURE(text);
    CHECK_FALSE(base64url_decode(text).has_value());
  }
  CHECK(rc::check(
      [](const std::string& bytes) { RC_ASSERT(base64url_decode(base64url_encode(bytes)) == bytes); }));
}

TEST_CASE("a token with anything changed, left out or added is not accepted") {
  const std::string good = token({"alice", {Right::read, Right::edit}, kNow + 1h});
  CHECK(rc::check([&] {
    std::string bad = good;
    const auto at = *rc::gen::inRange<std::size_t>(0, good.size());
    const auto with = *rc::gen::arbitrary<char>();
    switch (*rc::gen::inRange(0, 3)) {
      case 0:
        RC_PRE(with != good[at]);
        bad[at] = with;
        break;
      case 1:
        bad.erase(at, 1);
        break;
      default:
        bad.insert(at, 1, with);
    }
    RC_ASSERT(!read(bad).has_value());
  }));
}

TEST_CASE("a token with an empty part is refused before its signature is checked") {
  const std::string good = token({"a", {Right::read}, kNow + 1h});
  const std::size_t first = good.find('.');
  const std::size_t second = good.rfind('.');
  for (const std::string& bad : {good.substr(first), good.substr(0, first + 1) + good.substr(second),
                                 good.substr(0, second + 1), std::string{".."}}) {
    CAPTURE(bad);
    CHECK(read(bad).error().reason == "it is no signed token");
  }
}

TEST_CASE("no text is accepted, however long") {
  CHECK(rc::check([](const std::string& text) { RC_ASSERT(!read(text).has_value()); }));
  for (const std::size_t dots : {0, 1, 2, 3}) {
    CHECK_FALSE(read(std::string(dots, '.')).has_value());
    CHECK_FALSE(read(std::string(4'000'000, 'A') + std::string(dots, '.')).has_value());
  }
  CHECK_FALSE(read(std::string("a\0b.c.d", 7)).has_value());
}

TEST_CASE("an error about a key file is one line that names the setting and the file") {
  const ScratchDirectory scratch;
  const auto secret = [&](const std::string& file) { return load_error({file, "read", {}, "auto"}); };
  const std::string brief = scratch.write("brief", "only 15 bytes..\n");
  CHECK_THAT(secret(brief),
             Catch::StartsWith("access.secret_file " + brief + ": has 15 bytes; it must have 16 to 1024"));
  CHECK_THAT(secret(scratch.write("long", std::string(1025, 'x'))), Catch::Contains("has 1025 bytes"));
  CHECK_THAT(secret(scratch.write("huge", std::string(100'000, 'x'))), Catch::Contains("over 8192"));
  CHECK_THAT(secret("/nowhere"), Catch::Contains("No such file"));
  CHECK_THAT(secret(scratch.path().string()), Catch::Contains("not a regular file"));
  const std::string pipe = (scratch.path() / "pipe").string();
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  CHECK_THAT(secret(pipe), Catch::Contains("not a regular file"));
  const std::string key = scratch.write("key", std::string(31, 'k'));
  CHECK_THAT(load_error({{}, "read", key, "auto"}),
             Catch::StartsWith("access.signing_key_file " + key + ": has 31 bytes; it must have 32 to 4096"));
}

TEST_CASE("a single trailing newline is ignored, and nothing else is") {
  const ScratchDirectory scratch;
  const std::string text(16, 's');
  for (const std::string end : {"", "\n", "\r\n"}) {
    CHECK(read_key_file(scratch.write("file", text + end), {16, 16})->secret.bytes() == text);
  }
  CHECK(read_key_file(scratch.write("file", text + "\n\n"), {1, 20})->secret.bytes() == text + "\n");
}

TEST_CASE("a key file that other users may read or change is a warning") {
  const Files files;
  for (const mode_t mode : {0600U, 0400U, 0640U, 0440U}) {
    REQUIRE(::chmod(files.settings.secret_file.c_str(), mode) == 0);
    REQUIRE(::chmod(files.settings.signing_key_file.c_str(), mode) == 0);
    CHECK(load_keys(files.settings)->warnings.empty());
  }
  for (const mode_t mode : {0644U, 0604U, 0602U, 0660U}) {
    REQUIRE(::chmod(files.settings.secret_file.c_str(), mode) == 0);
    CAPTURE(mode);
    const auto keys = load_keys(files.settings);
    REQUIRE(keys->warnings.size() == 1);
    CHECK_THAT(keys->warnings[0], Catch::StartsWith("access.secret_file ") && Catch::Contains("chmod"));
  }
}

TEST_CASE("a configuration that lets nobody in is refused") {
  CHECK_THAT(load_error({{}, "read", {}, "none"}), Catch::StartsWith("access.without_token"));
}

TEST_CASE("a reload takes the new keys, and keeps all old keys if one file is bad") {
  Files files;
  AccessControl access = control_of(files.settings);
  const std::string fresh = "a secret for tomorrow";
  files.scratch.write("secret", fresh);
  CHECK(access.admit(kSecretText, kNow).has_value());
  REQUIRE(access.reload().has_value());
  CHECK_FALSE(access.admit(kSecretText, kNow).has_value());
  CHECK(access.admit(fresh, kNow).has_value());

  files.scratch.write("secret", "the secret after tomorrow");
  files.scratch.write("key", "short");
  const auto failed = access.reload();
  REQUIRE_FALSE(failed.has_value());
  CHECK_THAT(failed.error(), Catch::Contains("access.signing_key_file") && Catch::Contains("old keys stay"));
  CHECK(access.admit(fresh, kNow).has_value());
  CHECK(access.admit(token({"a", {Right::read}, kNow + 1h}), kNow).has_value());
  CHECK_FALSE(access.admit("", kNow).has_value());
}

TEST_CASE("tokens of the current and of the previous signing key are accepted, of a third are not") {
  Files files;
  const std::string before = "fedcba9876543210fedcba9876543210";
  files.settings.previous_signing_key_file = files.scratch.write("key.before", before);
  AccessControl access = control_of(files.settings);
  const Claims claims{"a", {Right::read}, kNow + 1h};
  CHECK(access.admit(token(claims), kNow).has_value());
  CHECK(access.admit(token(claims, before), kNow).has_value());
  CHECK(denied(access.admit(token(claims, std::string(32, 'x')), kNow)).failure == AuthFailure::not_accepted);
  CHECK(denied(access.admit(token(claims, before), kNow + 2h)).failure == AuthFailure::expired);
  CHECK(denied(access.admit(token(claims), kNow + 2h)).failure == AuthFailure::expired);

  files.scratch.write("key.before", kKeyText);
  REQUIRE(access.reload().has_value());
  CHECK_FALSE(access.admit(token(claims, before), kNow).has_value());
  CHECK(access.admit(token(claims), kNow).has_value());
}

TEST_CASE("rights are read back from their text, and read is among them") {
  for (const char* text : {"none", "read", "read,edit", "read,admin", "read,edit,admin"}) {
    CHECK(to_string(*Rights::parse(text)) == text);
  }
  CHECK(Rights::parse("edit,read") == Rights{Right::read, Right::edit});
  for (const char* text : {"", ",", "read,", ",read", "edit", "Read", "read edit", "none,read", "root"}) {
    CAPTURE(text);
    CHECK_FALSE(Rights::parse(text).has_value());
  }
}

TEST_CASE("talusd token makes tokens that the server accepts") {
  const Files files;
  const std::string key = files.settings.signing_key_file.string();
  const auto made = command({"--key-file", key.c_str(), "--subject", "Zo\xc3\xab \"the\" editor\n",
                             "--rights", "edit,read", "--valid", "12h"});
  REQUIRE(made.has_value());
  const auto claims = read(*made);
  REQUIRE(claims.has_value());
  CHECK(claims->subject == "Zo\xc3\xab \"the\" editor\n");
  CHECK(claims->rights == Rights{Right::read, Right::edit});
  CHECK(claims->expires == kNow + 12h);
}

TEST_CASE("talusd token says in one line what is wrong") {
  const Files files;
  const std::string key = files.settings.signing_key_file.string();
  const std::string brief = files.settings.secret_file.string();
  const std::string endless(8000, 'n');
  const auto wrong = [&](const char* file, const char* subject, const char* rights, const char* valid) {
    const auto made =
        command({"--key-file", file, "--subject", subject, "--rights", rights, "--valid", valid});
    REQUIRE_FALSE(made.has_value());
    CHECK(std::count(made.error().text.begin(), made.error().text.end(), '\n') == 1);
    CHECK_THAT(made.error().text, Catch::StartsWith("talusd token: "));
    return made.error().status;
  };
  CHECK(wrong(key.c_str(), "a", "write", "12h") == 2);
  CHECK(wrong(key.c_str(), "a", "none", "12h") == 2);
  for (const char* valid :
       {"", "12", "h", "0h", "-1h", "1.5h", "3651d", "9223372036854775807d", "12 h", "1w"}) {
    CAPTURE(valid);
    CHECK(wrong(key.c_str(), "a", "read", valid) == 2);
  }
  CHECK(wrong("/nowhere", "a", "read", "12h") == 1);
  CHECK(wrong(brief.c_str(), "a", "read", "12h") == 1);
  CHECK(wrong(key.c_str(), "\xff\xfe", "read", "12h") == 1);
  CHECK(wrong(key.c_str(), endless.c_str(), "read", "12h") == 1);
  CHECK(command({}).error().status == 2);
  CHECK(command({"--help"}).error().status == 0);
}
