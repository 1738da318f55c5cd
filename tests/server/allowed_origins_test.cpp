#include <catch2/catch.hpp>

#include "config/allowed_origins.h"

using namespace talus::server;

TEST_CASE("a page of the server's own host is always allowed") {
  const AllowedOrigins none;
  CHECK(none.allow("https://play.example", "play.example"));
  CHECK(none.allow("http://127.0.0.1:4782", "127.0.0.1:4782"));
  CHECK_FALSE(none.allow("https://play.example.evil", "play.example"));
  CHECK_FALSE(none.allow("null", "play.example"));
  CHECK_FALSE(none.allow("", ""));
  CHECK(none.unset());
  CHECK(AllowedOrigins::parse("")->unset());
}

TEST_CASE("an origin and a host are compared as URLs are") {
  const AllowedOrigins none;
  CHECK(none.allow("https://play.example", "play.example:443"));
  CHECK(none.allow("https://play.example:443", "play.example"));
  CHECK(none.allow("http://play.example", "play.example:80"));
  CHECK(none.allow("https://play.example", "Play.Example"));
  CHECK(none.allow("HTTPS://PLAY.example", "play.example."));
  CHECK(none.allow("http://[::1]:8080", "[::1]:8080"));
  CHECK(none.allow("https://[2001:DB8::1]", "[2001:db8::1]:443"));
  CHECK_FALSE(none.allow("http://play.example", "play.example:443"));
  CHECK_FALSE(none.allow("https://play.example", "play.example:80"));
  CHECK_FALSE(none.allow("https://play.example:8443", "play.example"));
  CHECK_FALSE(none.allow("https://play.example", "play.example:443:443"));
  CHECK_FALSE(none.allow("https://play.example@evil.example", "evil.example"));
  CHECK_FALSE(none.allow("https://play.example/", "play.example"));
  CHECK_FALSE(none.allow("ftp://play.example", "play.example"));
}

TEST_CASE("pages of the same machine are allowed only if loopback is") {
  AllowedOrigins local;
  for (const bool allowed : {false, true}) {
    for (const auto* origin : {"http://localhost:5173", "http://LOCALHOST:5173", "https://game.localhost",
                               "http://127.0.0.1:8000", "http://127.7.7.7", "http://[::1]:8000"}) {
      CAPTURE(origin, allowed);
      CHECK(local.allow(origin, "127.0.0.1:4782") == allowed);
      CHECK_FALSE(local.lists(origin));
    }
    for (const auto* origin :
         {"https://b.example", "http://127.0.0.1.evil.example", "http://localhost.evil.example",
          "http://notlocalhost", "http://192.168.0.2", "http://[::2]", "null"}) {
      CAPTURE(origin);
      CHECK_FALSE(local.allow(origin, "127.0.0.1:4782"));
    }
    local.allow_loopback();
  }
}

TEST_CASE("a listed origin may have a default port, capitals and a dot at its end") {
  const auto some = AllowedOrigins::parse("https://A.example:443, http://b.example.:80");
  REQUIRE(some);
  CHECK(some->allow("https://a.example", "x"));
  CHECK(some->allow("http://b.example", "x"));
  CHECK(some->lists("https://a.example"));
  CHECK_FALSE(some->lists("https://A.example"));  // another spelling would be another copy in caches
}

TEST_CASE("listed origins are allowed, and * means all") {
  const auto some = AllowedOrigins::parse("https://a.example, http://localhost:5173");
  REQUIRE(some);
  CHECK(some->allow("https://a.example", "b"));
  CHECK(some->allow("http://localhost:5173", "b"));
  CHECK_FALSE(some->allow("http://a.example", "b"));
  CHECK(some->allow("https://b", "b"));
  CHECK(some->lists("https://a.example"));
  CHECK_FALSE(some->lists("https://b"));  // allowed by its host alone
  CHECK_FALSE(some->all());
  CHECK_FALSE(some->unset());
  const auto all = AllowedOrigins::parse("*");
  REQUIRE(all);
  CHECK(all->all());
  CHECK_FALSE(all->unset());
  CHECK(all->allow("https://anything", ""));
}

TEST_CASE("an invalid origin is refused by name") {
  for (const auto* text :
       {"a.example", "https://", "https://a.example/path", "ftp://a", "https://a b", "https://*.example",
        "https://a:b", "https://a:65536", "https://h\xc3\xb6he.example", "https://[::1", "https://a@b"}) {
    const auto parsed = AllowedOrigins::parse(text);
    REQUIRE_FALSE(parsed);
    CHECK_THAT(parsed.error(), Catch::Contains(text) && Catch::Contains("https://play.example"));
  }
}
