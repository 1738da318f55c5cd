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
       {"a.example", "https://", "https://a.example/path", "https://A.example", "ftp://a", "https://a b"}) {
    const auto parsed = AllowedOrigins::parse(text);
    REQUIRE_FALSE(parsed);
    CHECK_THAT(parsed.error(), Catch::Contains(text) && Catch::Contains("https://play.example"));
  }
}
