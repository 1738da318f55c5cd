#include "config/access/revoked_tokens.h"

#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <string>

#include "config/access/access_control.h"
#include "scratch_directory.h"
#include "signed_tokens.h"

using namespace talus::server;
using namespace std::chrono_literals;

namespace {

// kNow is 2027-01-15T08:00:00Z.
const std::string kBeforeNow = "2027-01-15T07:59:59Z";
const std::string kAfterNow = "2027-01-15T08:00:01Z";

std::string error_of(const std::string& text) {
  const auto revoked = RevokedTokens::parse(text);
  return revoked ? "none" : revoked.error();
}

Claims claims(const std::string& subject, const std::string& id) {
  return {subject, {Right::read}, kNow + 1h, id, {}};
}

struct Files {
  ScratchDirectory scratch;
  Access settings{{}, "read", scratch.write("key", kKeyText), "auto", {}, scratch.write("revoked", "")};

  void revoke(const std::string& lines) { (void)scratch.write("revoked", lines); }
};

}  // namespace

TEST_CASE("a list names tokens by jti, or by subject and the time before which they were issued") {
  const auto revoked =
      RevokedTokens::parse("# who left\n\n  jti a-1\r\nsub " + kAfterNow + "  alice of the hills \n");
  REQUIRE(revoked);
  CHECK(revoked->size() == 2);
  CHECK(revoked->contains("a-1", "", kNow));
  CHECK_FALSE(revoked->contains("a-2", "bob", kNow));
  CHECK_FALSE(revoked->contains("", "", {}));
  CHECK(revoked->contains("", "alice of the hills", kNow));
  CHECK(revoked->contains("", "alice of the hills", {}));
  CHECK_FALSE(revoked->contains("", "alice of the hills", kNow + 1s));
  CHECK_FALSE(revoked->contains("", "alice", kNow));
}

TEST_CASE("the later time of two lines of one subject counts") {
  for (const auto& [first, second] : {std::pair{kBeforeNow, kAfterNow}, std::pair{kAfterNow, kBeforeNow}}) {
    const auto revoked = RevokedTokens::parse("sub " + first + " a\nsub " + second + " a");
    CHECK(revoked.value().contains("", "a", kNow));
  }
}

TEST_CASE("a bad line is named by its number") {
  CHECK(error_of("jti a\nnonsense") == "line 2: \"nonsense\" is neither \"jti ID\" nor \"sub TIME SUBJECT\"");
  CHECK_THAT(error_of("jti"), Catch::StartsWith("line 1: \"jti\" is neither"));
  for (const char* time : {"2026-13-01T00:00:00Z", "2026-02-30T00:00:00Z", "2026-01-01T24:00:00Z",
                           "2026-01-01T00:00:00", "2026-1-01T00:00:00Z", "2026-01-01T00:00:00Zz", "now"}) {
    CHECK(error_of(std::string{"sub "} + time + " alice") ==
          "line 1: the TIME after sub is not like 2026-11-22T18:30:00Z");
  }
  CHECK(error_of("sub " + kAfterNow) == "line 1: no SUBJECT after the TIME");
  CHECK(error_of(std::string(100'000, '\x01')).size() < 600);
}

TEST_CASE("a revoked token is refused, and no other") {
  Files files;
  files.revoke("jti one\nsub " + kAfterNow + " alice\n");
  const AccessControl access{files.settings, *load_keys(files.settings)};
  CHECK(access.admit(token(claims("bob", "one")), kNow).error().failure == AuthFailure::revoked);
  CHECK(access.admit(token(claims("alice", "")), kNow).error().failure == AuthFailure::revoked);
  CHECK(access.admit(token(claims("bob", "two")), kNow).has_value());
}

TEST_CASE("a reload revokes the tokens of connected clients, and a bad list changes nothing") {
  Files files;
  AccessControl access{files.settings, *load_keys(files.settings)};
  const Grant grant = access.admit(token(claims("alice", "one")), kNow).value();
  CHECK(grant.token_id == "one");
  CHECK(grant.issued == kNow);
  CHECK_FALSE(access.withdrawn(grant));
  files.revoke("jti one\n");
  CHECK_THAT(access.reload(files.settings).value(), Catch::Contains("1 lines of revoked tokens"));
  CHECK(access.withdrawn(grant));
  files.revoke("jti two\nrubbish\n");
  CHECK_THAT(access.reload(files.settings).error(),
             Catch::Contains("revoked: line 2: ") && Catch::Contains("old list stays in use"));
  CHECK(access.withdrawn(grant));
  CHECK_FALSE(access.admit(token(claims("alice", "one")), kNow).has_value());
}

TEST_CASE("a list that cannot be read, or revokes nothing, is an error of its setting") {
  Files files;
  files.settings.revoked_file = "/nowhere";
  CHECK_THAT(load_keys(files.settings).error(), Catch::StartsWith("access.revoked_file /nowhere: "));
  const std::string pipe = (files.scratch.path() / "pipe").string();
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  files.settings.revoked_file = pipe;
  CHECK_THAT(load_keys(files.settings).error(), Catch::Contains("regular file"));
  Files without_key;
  without_key.settings.signing_key_file.clear();
  CHECK_THAT(load_keys(without_key.settings).error(), Catch::Contains("access.signing_key_file"));
}
