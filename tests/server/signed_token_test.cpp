// Signed tokens: which are read, and that no others are.
#include "config/access/signed_token.h"

#include <openssl/evp.h>
#include <openssl/hmac.h>
#include <rapidcheck.h>

#include <array>
#include <catch2/catch.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "config/access/base64url.h"
#include "signed_tokens.h"

using namespace talus::server;
using namespace std::chrono_literals;
using std::chrono::sys_seconds;

namespace {

const std::string kGoodClaims = R"({"exp": 1800009999})";

}  // namespace

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

TEST_CASE("boxes in a token are texts of boxes, or the token is not accepted") {
  const auto with = [](const std::string& more) {
    return read(raw_token(kHs256, R"({"exp": 1800009999, )" + more + "}"));
  };
  const auto good = with(R"("edit_in": "0,0:1,1", "edit_not_in": "")");
  REQUIRE(good.has_value());
  CHECK(good->edit_in->text() == "0,0:1,1");
  CHECK(good->edit_not_in.empty());
  for (const char* wrong : {R"("edit_in": 7)", R"("edit_in": ["0,0:1,1"])", R"("edit_in": "0,0")",
                            R"("edit_not_in": {})", R"("edit_not_in": "all")", R"("edit_in": null)"}) {
    CAPTURE(wrong);
    const auto refused = with(wrong);
    REQUIRE_FALSE(refused.has_value());
    CHECK(refused.error().signed_by_key);
    CHECK_THAT(refused.error().reason, Catch::Contains("edit_"));
  }
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

TEST_CASE("the last of a claim that appears twice counts") {
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
                             R"({"exp": 1e19})",
                             R"({"exp": -0.5})",
                             R"({"exp": 1800009999, "nbf": 1e300})",
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

TEST_CASE("times with a fraction of a second, and blanks between rights, are read") {
  const auto claims = read(raw_token(
      kHs256, R"({"exp": 1800009999.5, "nbf": 1.8e9, "iat": 1799999999.25, "rights": " read, edit "})"));
  REQUIRE(claims.has_value());
  CHECK(claims->expires == sys_seconds{1'800'009'999s});
  CHECK(claims->issued == sys_seconds{1'799'999'999s});
  CHECK(claims->rights == Rights{Right::read, Right::edit});
  CHECK_FALSE(read(raw_token(kHs256, R"({"exp": 1800009999, "nbf": 1800000030.5})"), kNow - 1s).has_value());
}

TEST_CASE("a token that is refused for a claim names it") {
  const auto [claims, reason] = GENERATE(table<const char*, const char*>(
      {{R"({})", "it has no exp"},
       {R"({"exp": "1800009999"})", "its exp is not a number of seconds since 1970, but of type string"},
       {R"({"exp": 1e300})", "its exp is not a time in seconds since 1970"},
       {R"({"exp": 1800009999, "nbf": 1800000100})", "it is not valid yet, for 100 s: nbf"},
       {R"({"exp": 1800009999, "rights": ["read"]})", R"(its rights are not a string such as "read,edit")"},
       {R"({"exp": 1800009999, "rights": "raed"})",
        R"(its rights: "raed" is wrong; give "read", "read,edit", or that with ",admin" or ",gateway")"},
       {R"({"exp": 1800009999, "rights": "none"})", "its rights lack read"}}));
  const auto refused = read(raw_token(kHs256, claims));
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().signed_by_key);
  CHECK(refused.error().reason == reason);
}

TEST_CASE("a token whose parts are padded says so to the operator") {
  const std::string good = token({"alice", {Right::read}, kNow + 1h});
  for (const std::string& text : {good + "=", good + "\n", good.substr(0, 10) + "==" + good.substr(10)}) {
    const auto refused = read(text);
    REQUIRE_FALSE(refused.has_value());
    CHECK_FALSE(refused.error().signed_by_key);
    CHECK_THAT(refused.error().reason, Catch::StartsWith("it has padding (=)"));
  }
}

TEST_CASE("base64url is as in RFC 4648, without padding") {
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
  // With the other alphabet, padded.
  CHECK(base64_decode("") == "");
  CHECK(base64_decode("Zg==") == "f");
  CHECK(base64_decode("Zm8=") == "fo");
  CHECK(base64_decode("+/8A") == std::string{"\xFB\xFF\0", 3});
  for (const std::string_view text : {"Zg", "Zg=", "Zg===", "=", "====", "Z=g=", "-_8A", "Zm8 ", "Zm8=Zm8="})
    CHECK_FALSE(base64_decode(text).has_value());
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
    CHECK(read(bad).error().reason == "it is not a signed token");
  }
}

TEST_CASE("no text is accepted, however long") {
  CHECK(rc::check([](const std::string& text) { RC_ASSERT(!read(text).has_value()); }));
  for (const std::size_t dots : {0U, 1U, 2U, 3U}) {
    CHECK_FALSE(read(std::string(dots, '.')).has_value());
    CHECK_FALSE(read(std::string(4'000'000, 'A') + std::string(dots, '.')).has_value());
  }
  CHECK_FALSE(read(std::string("a\0b.c.d", 7)).has_value());
}
