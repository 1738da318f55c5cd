// What a session lets a client do by its token.
#include <catch2/catch.hpp>

#include "config/access/signed_token.h"
#include "scratch_directory.h"
#include "session_bench.h"

using namespace talus;
using namespace talus::server;
using namespace std::chrono_literals;
using State = Session::State;

namespace {

const std::string kKey = "0123456789abcdef0123456789abcdef";

/// A session that asks for a token signed by kKey, before its Hello.
struct Bench {
  ScratchDirectory scratch;
  Access settings{{},
                  "read",
                  scratch.write("key", kKey),
                  "auto",
                  {},
                  scratch.write("revoked", ""),
                  scratch.write("blocked", "")};
  SessionBench bench{{.access = settings, .greet = false}};

  [[nodiscard]] std::string token(Rights rights, std::chrono::seconds lasts = 1h) const {
    return *make_signed_token(Secret{kKey}, {"a", rights, bench.clock.wall() + lasts}, bench.clock.wall());
  }
};

}  // namespace

TEST_CASE("without a token a session ends with an Error that asks for one") {
  Bench shared;
  SessionBench& bench = shared.bench;
  bench.hello();
  const auto said = bench.output();
  REQUIRE(said.size() == 1);
  CHECK(said[0].code == wire::ErrorCode::unauthorized);
  CHECK_THAT(said[0].text, Catch::Contains("token"));
  CHECK(bench.session.state() == State::closed);
  CHECK_FALSE(bench.session.greeting().has_value());
  CHECK(bench.metrics.denied(AuthFailure::missing).total() == 1);
}

TEST_CASE("a client learns that its token expired or is not accepted, and the log learns why") {
  Bench shared;
  SessionBench& bench = shared.bench;
  const auto [shown, text, why] = GENERATE_REF(table<std::string, std::string, std::string>(
      {{shared.token({Right::read}, -1h), "the token has expired", "it expired 36"},
       {shared.token({Right::read}) + "A", "the token is not accepted", "signature"},
       {"guess", "the token is not accepted", "not a signed token"}}));
  bench.hello(shown);
  const auto said = bench.output();
  REQUIRE(said.size() == 1);
  CHECK(said[0].code == wire::ErrorCode::unauthorized);
  CHECK(said[0].text == text);
  CHECK_THAT(bench.session.failure(), Catch::Contains(text) && Catch::Contains(why));
  const AuthFailure denial = text.ends_with("expired") ? AuthFailure::expired : AuthFailure::not_accepted;
  CHECK(bench.metrics.denied(denial).total() == 1);
}

TEST_CASE("a session is of its token's flow, whatever its address") {
  Bench shared;
  SessionBench& bench = shared.bench;
  const FlowId of_address = bench.mailbox->flow();
  bench.hello(shared.token({Right::read}));
  CHECK(bench.mailbox->flow() == bench.flows.ids().of_subject("a"));
  CHECK(bench.mailbox->flow() != of_address);
}

TEST_CASE("a session whose token is revoked ends, and another goes on") {
  for (const bool listed : {true, false}) {
    Bench shared;
    SessionBench& bench = shared.bench;
    bench.hello(shared.token({Right::read}));
    (void)bench.output();
    (void)shared.scratch.write("revoked", listed ? "sub 2100-01-01T00:00:00Z a\n" : "jti another\n");
    REQUIRE(bench.access.reload(shared.settings).has_value());
    bench.session.access_changed(false);
    const auto said = bench.output();
    CHECK((bench.session.state() == State::closed) == listed);
    CHECK(bench.metrics.denied(AuthFailure::revoked).total() == (listed ? 1 : 0));
    if (listed) CHECK(said.at(0).text == "the token was revoked");
  }
}

TEST_CASE("a session whose subject or address is blocked ends, and another goes on") {
  const auto [lines, by_address, ends] = GENERATE(table<std::string, bool, bool>(
      {{"subject a\n", false, true}, {"subject b\n", false, false}, {"", true, true}}));
  const bool greeted = GENERATE(true, false);
  Bench shared;
  SessionBench& bench = shared.bench;
  if (greeted) bench.hello(shared.token({Right::read}));
  (void)bench.output();
  (void)shared.scratch.write("blocked", lines);
  REQUIRE(bench.access.reload(shared.settings).has_value());
  bench.session.access_changed(by_address);
  // Before its Hello nobody knows whose session it is.
  CHECK((bench.session.state() == State::closed) == (ends && (greeted || by_address)));
  if (bench.session.state() != State::closed) return;
  const auto said = bench.output();
  CHECK(said.at(0).code == wire::ErrorCode::unauthorized);
  CHECK(said.at(0).text == "this server's operator has blocked you");
  CHECK(bench.metrics.denied(AuthFailure::blocked).total() == 1);
}

TEST_CASE("a client with a blocked subject is refused, and logged from the second time on") {
  Bench shared;
  (void)shared.scratch.write("blocked", "# the flood of Monday\nsubject a\n");
  REQUIRE(shared.bench.access.reload(shared.settings).has_value());
  for (const bool known : {false, true}) {
    SessionBench& first = shared.bench;
    Session session{{first.limits, first.world, first.source, first.memory, first.metrics, first.access,
                     first.rates, first.flows, first.clock},
                    std::make_shared<Mailbox>(ClientId{2}, [] {}),
                    nullptr};
    session.receive(protocol::make_frame([&](auto& builder) {
      const auto codecs = builder.CreateVector(std::vector{kCodecVersion});
      return wire::CreateHello(builder, protocol::kOldestProtocol, protocol::kProtocolVersion, codecs,
                               builder.CreateString(shared.token({Right::read})));
    }));
    CHECK_THAT(session.failure(), Catch::Contains("blocked you (line 2 of access.blocked_file)"));
    CHECK(session.failure_is_known() == known);
  }
}

TEST_CASE("a token is checked by the session's clock") {
  Bench shared;
  SessionBench& bench = shared.bench;
  const std::string token = shared.token({Right::read}, 1h);
  bench.clock.advance(2h);
  bench.hello(token);
  CHECK(bench.output().at(0).text == "the token has expired");
}

TEST_CASE("an Edit without the right is forbidden, and the session stays") {
  Bench shared;
  SessionBench& bench = shared.bench;
  bench.hello(shared.token({Right::read}));
  (void)bench.output();
  bench.edit(5);
  const auto said = bench.output();
  REQUIRE(said.size() == 1);
  CHECK(said[0].code == wire::ErrorCode::forbidden);
  CHECK(said[0].id == 5);
  CHECK(bench.session.state() == State::joined);
}

TEST_CASE("an Edit with the right is unsupported") {
  Bench shared;
  SessionBench& bench = shared.bench;
  bench.hello(shared.token({Right::read, Right::edit}));
  (void)bench.output();
  bench.edit(5);
  CHECK(bench.output().at(0).code == wire::ErrorCode::unsupported);
}

TEST_CASE("a session ends when its token does") {
  Bench shared;
  SessionBench& bench = shared.bench;
  bench.hello(shared.token({Right::read}));
  (void)bench.output();
  bench.session.token_expired();
  CHECK(bench.output().at(0).text == "the token has expired");
  CHECK(bench.session.state() == State::closed);
  CHECK(bench.metrics.denied(AuthFailure::expired).total() == 1);
}
