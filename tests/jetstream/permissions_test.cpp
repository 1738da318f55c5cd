// Who comes in, and what he may do there, by real nats-servers.
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "certificates.h"
#include "cluster/jetstream/nkey.h"
#include "log_of_tests.h"
#include "scratch_directory.h"

using namespace talus::nats_test;
using namespace talus::server;
using namespace talus::server::jetstream;
using namespace std::chrono_literals;

TEST_CASE("a refused user gets the reason, and connects once permitted") {
  OneServer one("authorization { users = [ { user: talus, password: right } ] }");
  Credentials wrong;
  wrong.user = "talus";
  wrong.password.emplace("wrong");
  const auto log = open_log(one.servers.url_list(), one.names, std::move(wrong));
  const auto failure = [&] {
    const auto until = from_now(kPatience);
    for (;;) {
      const auto message = log->next(0, from_now(100ms));
      REQUIRE_FALSE((message && *message));
      if (!message && message.error().kind == Kind::refused) return message.error();
      REQUIRE(std::chrono::steady_clock::now() < until);
    }
  }();
  CHECK_THAT(failure.reason, Catch::Contains("uthorization"));
  CHECK_FALSE(log->publish(bytes_of("a")));
}

TEST_CASE("a missing permission is named") {
  OneServer one(
      "authorization { users = [ { user: all, password: p }, { user: talus, password: p, permissions: { "
      "publish: [\"$JS.API.STREAM.INFO.>\"], subscribe: [\"_INBOX.>\"] } } ] }");
  Credentials who;
  who.user = "talus";
  who.password.emplace("p");
  const auto log = open_log(one.servers.url_list(), one.names, std::move(who));
  const auto published = log->publish(bytes_of("a"));
  REQUIRE_FALSE(published);
  CHECK(published.error().kind == Kind::refused);
  CHECK_THAT(published.error().reason,
             Catch::Contains("ermissions") && Catch::Contains("Publish") && Catch::Contains(one.names.log));
  CHECK(read_failure(*log, 0).kind == Kind::refused);
}

TEST_CASE("without the permission to read messages the log cannot be reached, until it is back") {
  OneServer one{talusd_permissions()};
  make_stream(one.servers, one.names, 1);
  const auto log = open_log(one.servers.url_list(), one.names, as_talusd());
  publish(*log, "a");
  CHECK(read(*log, 0) == "a");
  REQUIRE(log->state());
  one.servers.reconfigure(talusd_permissions({.messages = false}));
  const auto unreadable = [&](const StreamFailure& failure) {
    return failure.kind == Kind::unavailable &&
           failure.reason.find("messages of " + one.names.stream + " cannot be read") != std::string::npos &&
           failure.reason.find("ermissions") != std::string::npos &&
           failure.reason.find("MSG.GET") != std::string::npos;
  };
  const auto ends = from_now(kPatience);
  for (bool was = false; !was;) {
    (void)log->next(1, from_now(100ms));
    const auto state = log->state();
    was = !state && unreadable(state.error());
    REQUIRE(std::chrono::steady_clock::now() < ends);
  }
  CHECK_FALSE(log->time_of(1));
  // Nor by another connection, of which nothing was asked yet.
  one.servers.end(0);
  const auto fails_as = [&](bool wanted) {
    const auto state = log->state();
    REQUIRE_FALSE(state);
    return unreadable(state.error()) == wanted;
  };
  while (!fails_as(false)) {
  }
  one.servers.start(0);
  while (!fails_as(true)) {
  }
  one.servers.reconfigure(talusd_permissions());
  const auto until = from_now(kPatience);
  while (!log->state()) REQUIRE(std::chrono::steady_clock::now() < until);
  CHECK(log->time_of(1));
  CHECK(log->state());
}

TEST_CASE("without the permission to subscribe to the tail messages are asked for, until it is back") {
  OneServer one{talusd_permissions()};
  make_stream(one.servers, one.names, 1);
  const auto log = open_log(one.servers.url_list(), one.names, as_talusd());
  const auto other = open_log(one.servers.url_list(), one.names);
  publish(*other, "a");
  CHECK(read(*log, 0) == "a");
  CHECK(log->figures().late.empty());
  std::uint64_t last = 1;
  const auto until_late = [&](bool wanted) {
    const auto until = from_now(kPatience);
    while (log->figures().late.empty() == wanted) {
      REQUIRE(log->next(last, from_now(10ms)));
      REQUIRE(std::chrono::steady_clock::now() < until);
    }
  };
  one.servers.reconfigure(talusd_permissions({.tail = false}));
  until_late(true);
  CHECK_THAT(log->figures().late, Catch::Contains("Subscription") && Catch::Contains(one.names.tail));
  publish(*other, "b");
  CHECK(read(*log, last++) == "b");
  CHECK(log->state());

  one.servers.reconfigure(talusd_permissions());
  until_late(false);
  // By the tail alone.
  one.servers.reconfigure(talusd_permissions({.messages = false}));
  publish(*other, "c");
  const auto until = from_now(kPatience);
  for (bool came = false; !came;) {
    const auto message = log->next(last, from_now(100ms));
    came = message && *message;
    REQUIRE(std::chrono::steady_clock::now() < until);
  }
}

TEST_CASE("without the permission to subscribe to answers the log cannot be reached, until it is back") {
  OneServer one{talusd_permissions()};
  make_stream(one.servers, one.names, 1);
  const auto log = open_log(one.servers.url_list(), one.names, as_talusd());
  publish(*log, "a");
  REQUIRE(log->state());
  one.servers.reconfigure(talusd_permissions({.answers = false}));
  const auto says_why = [](const StreamFailure& failure) {
    return failure.kind == Kind::unavailable && failure.reason.find("ermissions") != std::string::npos &&
           failure.reason.find("Subscription") != std::string::npos &&
           failure.reason.find("_INBOX") != std::string::npos;
  };
  const auto until = from_now(kPatience);
  for (auto state = log->state(); state || !says_why(state.error()); state = log->state()) {
    REQUIRE(std::chrono::steady_clock::now() < until);
  }
  const auto published = log->publish(bytes_of("b"));
  REQUIRE_FALSE(published);
  CHECK(says_why(published.error()));

  one.servers.reconfigure(talusd_permissions());
  while (!log->state()) REQUIRE(std::chrono::steady_clock::now() < until);
  publish(*log, "c");
  CHECK(log->time_of(1));
  CHECK(read(*log, 0) == "a");
}

namespace {

/// Keeps what NATS did not allow.
struct Denials : ConnectionEvents {
  void connected(bool /*now*/) override {}
  void closed(const StreamFailure& /*why*/) override {}
  void denied(std::string_view what) override {
    const std::lock_guard lock{mutex};
    texts.emplace_back(what);
    came.notify_all();
  }
  std::mutex mutex;
  std::condition_variable came;
  std::vector<std::string> texts;
};

}  // namespace

TEST_CASE("each of several refusals at once is reported with its own text") {
  OneServer one{talusd_permissions()};
  const auto denials = std::make_shared<Denials>();
  const auto connection =
      Connection::open(urls_of(one.servers.url_list()), std::make_shared<const Credentials>(as_talusd()),
                       denials, Retry::forever);
  REQUIRE(connection);
  constexpr std::size_t kSubjects = 50;
  std::vector<std::shared_ptr<Connection::Source>> sources;
  for (std::size_t i = 0; i < kSubjects; ++i) {
    const auto source = (*connection)->open_source("elsewhere." + std::to_string(i), 1, 1);
    REQUIRE(source);
    sources.push_back(*source);
  }
  std::unique_lock lock{denials->mutex};
  REQUIRE(denials->came.wait_for(lock, kPatience, [&] { return denials->texts.size() >= kSubjects; }));
  for (std::size_t i = 0; i < kSubjects; ++i) {
    CHECK_THAT(denials->texts[i], Catch::Contains("'elsewhere." + std::to_string(i) + "'"));
  }
}

TEST_CASE("all of several permissions removed at once come back") {
  OneServer one{talusd_permissions()};
  make_stream(one.servers, one.names, 1);
  const auto log = open_log(one.servers.url_list(), one.names, as_talusd());
  publish(*log, "a");
  CHECK(read(*log, 0) == "a");
  one.servers.reconfigure(talusd_permissions({.tail = false, .answers = false}));
  const auto until = from_now(kPatience);
  const auto await = [&](const auto& come) {
    while (!come()) {
      (void)log->next(1, from_now(10ms));
      REQUIRE(std::chrono::steady_clock::now() < until);
    }
  };
  await([&] { return log->figures().late.find(one.names.tail) != std::string::npos; });
  await([&] {
    const auto state = log->state();
    return !state && state.error().reason.find("_INBOX") != std::string::npos;
  });
  one.servers.reconfigure(talusd_permissions());
  await([&] { return log->state() && log->figures().late.empty(); });
  publish(*log, "b");
  CHECK(log->time_of(1));
}

TEST_CASE("user and password, token and NKey all open the door") {
  const std::string seed = "SUACSSL3UAHUDXKFSNVUZRF5UHPMWZ6BFDTJ7M6USDXIEDNPPQYYYCU3VY";
  const std::string key = *public_nkey(seed);
  Credentials who;
  std::string more;
  SECTION("user and password") {
    more = "authorization { user: talus, password: secret }";
    who.user = "talus";
    who.password.emplace("secret");
  }
  SECTION("token") {
    more = "authorization { token: secret }";
    who.token.emplace("secret");
  }
  SECTION("NKey") {
    more = "authorization { users = [ { nkey: " + key + " } ] }";
    who.seed.emplace(seed);
    who.public_key = key;
  }
  OneServer one(more);
  const auto log = open_log(one.servers.url_list(), one.names, std::move(who));
  const auto until = from_now(kPatience);
  for (;;) {
    const auto state = log->state();
    REQUIRE_FALSE(state);
    if (state.error().kind == Kind::refused) {
      CHECK_THAT(state.error().reason, Catch::Contains("talusd cluster init"));
      break;
    }
    REQUIRE(std::chrono::steady_clock::now() < until);
  }
}

TEST_CASE("TLS, of both sides") {
  const ScratchDirectory scratch;
  const TestCertificate server = make_certificate(1);
  const TestCertificate client = make_certificate(2, "talusd");
  const TestCertificate stranger = make_certificate(3);
  const std::string files = "cert_file: \"" + scratch.write("cert.pem", server.certificate) +
                            "\", key_file: \"" + scratch.write("key.pem", server.key) + "\"";
  const auto opens = [](NatsServers& servers, Credentials who) {
    const auto opened =
        Connection::open(urls_of(servers.url_list()), std::make_shared<const Credentials>(std::move(who)),
                         nullptr, Retry::never);
    return opened.has_value();
  };
  const auto who = [](const std::string& ca, const TestCertificate* own) {
    Credentials made;
    made.tls = true;
    made.ca = ca;
    if (own != nullptr) {
      made.certificate = own->certificate;
      made.key.emplace(own->key);
    }
    return made;
  };
  SECTION("the server's certificate must match cluster.ca and the server's name") {
    NatsServers servers{{.servers = 1, .jetstream = false, .more = "tls { " + files + " }", .scheme = "tls"}};
    CHECK(opens(servers, who(server.certificate, nullptr)));
    CHECK_FALSE(opens(servers, who(stranger.certificate, nullptr)));
    CHECK_FALSE(opens(servers, who({}, nullptr)));
  }
  SECTION("a certificate for another name") {
    const TestCertificate other = make_certificate(4, "elsewhere.example");
    NatsServers servers{{.servers = 1,
                         .jetstream = false,
                         .more = "tls { cert_file: \"" + scratch.write("o.pem", other.certificate) +
                                 "\", key_file: \"" + scratch.write("ok.pem", other.key) + "\" }",
                         .scheme = "tls"}};
    CHECK_FALSE(opens(servers, who(other.certificate, nullptr)));
  }
  SECTION("the client's certificate is asked for") {
    NatsServers servers{{.servers = 1,
                         .jetstream = false,
                         .more = "tls { " + files + ", ca_file: \"" +
                                 scratch.write("client.pem", client.certificate) + "\", verify: true }",
                         .scheme = "tls"}};
    CHECK(opens(servers, who(server.certificate, &client)));
    CHECK_FALSE(opens(servers, who(server.certificate, nullptr)));
    CHECK_FALSE(opens(servers, who(server.certificate, &stranger)));
  }
  SECTION("a server without TLS is not spoken to") {
    NatsServers servers{{.servers = 1, .jetstream = false, .scheme = "tls"}};
    CHECK_FALSE(opens(servers, who(server.certificate, nullptr)));
  }
}
