// The log of a cluster by real nats-servers.
#include <atomic>
#include <chrono>
#include <set>
#include <string>
#include <thread>

#include <catch2/catch.hpp>

#include "certificates.h"
#include "jetstream/nkey.h"
#include "jetstream/stream_settings.h"
#include "opened_stream.h"
#include "scratch_directory.h"

using namespace talus::nats_test;
using namespace talus::server;
using namespace talus::server::jetstream;
using namespace std::chrono_literals;
using Kind = StreamFailure::Kind;

namespace {

// An election of NATS takes up to 15 s on a busy machine.
constexpr auto kPatience = 60s;
// As the publisher does. Without it some thousand messages a second flood the servers that hold an election.
constexpr auto kRetry = 20ms;

LogStream::TimePoint from_now(std::chrono::milliseconds time) {
  return std::chrono::steady_clock::now() + time;
}

/// Again and again until a majority has it.
std::uint64_t publish(LogStream& log, std::string_view text) {
  const auto until = from_now(kPatience);
  for (;;) {
    const auto sequence = log.publish(bytes_of(text));
    if (sequence) return *sequence;
    INFO(sequence.error().reason);
    REQUIRE(std::chrono::steady_clock::now() < until);
    std::this_thread::sleep_for(kRetry);
  }
}

/// The text of the message after `after`, which comes some time.
std::string read(LogStream& log, std::uint64_t after) {
  const auto until = from_now(kPatience);
  for (;;) {
    const auto message = log.next(after, until);
    INFO((message ? std::string{} : message.error().reason));
    REQUIRE(std::chrono::steady_clock::now() < until);
    if (!message && message.error().kind == Kind::unavailable) continue;
    REQUIRE(message);
    if (!*message) continue;
    CHECK((*message)->sequence == after + 1);
    return text_of((*message)->bytes);
  }
}

/// Why next() fails for good; it may work until it notices.
StreamFailure read_failure(LogStream& log, std::uint64_t after) {
  const auto until = from_now(kPatience);
  for (;;) {
    const auto message = log.next(after, from_now(100ms));
    if (!message && message.error().kind != Kind::unavailable) return message.error();
    REQUIRE(std::chrono::steady_clock::now() < until);
  }
}

/// Why publish() fails for good.
StreamFailure publish_failure(LogStream& log) {
  const auto until = from_now(kPatience);
  for (;;) {
    const auto published = log.publish(bytes_of("a"));
    if (!published && published.error().kind != Kind::unavailable) return published.error();
    REQUIRE(std::chrono::steady_clock::now() < until);
  }
}

/// One server and a stream.
struct OneServer {
  explicit OneServer(const std::string& more = {}) : servers{{.servers = 1, .more = more}} {}
  NatsServers servers;
  StreamNames names = test_names();
};

}  // namespace

TEST_CASE("what one server publishes another reads, in order, from the first on") {
  OneServer one;
  make_stream(one.servers, one.names, 1);
  const auto writer = open_log(one.servers.url_list(), one.names);
  CHECK(publish(*writer, "a") == 1);
  CHECK(publish(*writer, std::string(512U << 10U, 'b')) == 2);

  const auto reader = open_log(one.servers.url_list(), one.names);
  CHECK(read(*reader, 0) == "a");
  CHECK(read(*reader, 1).size() == 512U << 10U);
  CHECK(publish(*writer, "c") == 3);
  CHECK(read(*reader, 2) == "c");
  CHECK(read(*writer, 0) == "a");
  CHECK(reader->figures().connected);

  const auto state = reader->state();
  REQUIRE(state);
  CHECK(state->first == 1);
  CHECK(state->last == 3);
  CHECK(state->created_ns > 1'700'000'000'000'000'000);
}

TEST_CASE("next() waits until its time, or until it is woken, and no longer") {
  OneServer one;
  make_stream(one.servers, one.names, 1);
  const auto log = open_log(one.servers.url_list(), one.names);
  const auto nothing = log->next(0, from_now(10ms));
  REQUIRE(nothing);
  CHECK_FALSE(*nothing);

  std::atomic<bool> returned{false};
  std::thread reader{[&] {
    const auto none = log->next(0, from_now(1h));
    returned = none.has_value() && !*none;
  }};
  log->wake();
  reader.join();
  CHECK(returned);
}

TEST_CASE("stop() ends what waits, and all that comes after") {
  OneServer one;
  const auto log = open_log(one.servers.url_list(), one.names);  // no stream: nobody answers
  std::thread reader{[&] {
    for (;;) {
      const auto message = log->next(0, from_now(1h));
      if (!message && message.error().reason == "stopped") return;
    }
  }};
  log->stop();
  reader.join();
  CHECK_FALSE(log->next(0, from_now(1h)));
  CHECK_FALSE(log->publish(bytes_of("a")));
  CHECK_FALSE(log->state());
}

TEST_CASE("a log without servers opens, and says so until they are there") {
  OneServer one;
  make_stream(one.servers, one.names, 1);
  one.servers.kill(0);
  const auto log = open_log(one.servers.url_list(), one.names);
  const auto published = log->publish(bytes_of("a"));
  REQUIRE_FALSE(published);
  CHECK(published.error().kind == Kind::unavailable);
  const auto message = log->next(0, from_now(50ms));
  REQUIRE_FALSE(message);
  CHECK(message.error().kind == Kind::unavailable);
  CHECK_FALSE(log->figures().connected);
  one.servers.start(0);
  CHECK(publish(*log, "a") == 1);
  CHECK(read(*log, 0) == "a");
}

TEST_CASE("a NATS server that takes connections and says nothing refuses nobody") {
  OneServer one;
  make_stream(one.servers, one.names, 1);
  one.servers.freeze(0);
  const auto log = open_log(one.servers.url_list(), one.names);
  const auto until = from_now(3s);  // longer than the attempts that libnats makes by itself
  while (std::chrono::steady_clock::now() < until) {
    const auto state = log->state();
    REQUIRE_FALSE(state);
    REQUIRE(state.error().kind == Kind::unavailable);
    (void)log->next(0, from_now(50ms));
  }
  one.servers.go_on(0);
  CHECK(publish(*log, "a") == 1);
  CHECK(read(*log, 0) == "a");
}

TEST_CASE("a long absence is read by number, many at once") {
  OneServer one;
  make_stream(one.servers, one.names, 1);
  const auto writer = open_log(one.servers.url_list(), one.names);
  constexpr std::uint64_t kMessages = 2000;
  for (std::uint64_t i = 1; i <= kMessages; ++i) REQUIRE(publish(*writer, std::to_string(i)) == i);
  const auto reader = open_log(one.servers.url_list(), one.names);
  for (std::uint64_t i = 0; i < kMessages; ++i) REQUIRE(read(*reader, i) == std::to_string(i + 1));
  // From anywhere, also back.
  CHECK(read(*reader, 500) == "501");
  CHECK(read(*reader, 1700) == "1701");
}

TEST_CASE("a stream that is missing is for a person, until it is made") {
  OneServer one;
  const auto log = open_log(one.servers.url_list(), one.names);
  const auto failure = read_failure(*log, 0);
  CHECK(failure.kind == Kind::refused);
  CHECK_THAT(failure.reason, Catch::Contains("talusd cluster init") && Catch::Contains(one.names.stream));
  const auto state = log->state();
  REQUIRE_FALSE(state);
  CHECK(state.error().kind == Kind::refused);
  make_stream(one.servers, one.names, 1);
  CHECK(publish(*log, "a") == 1);
  CHECK(read(*log, 0) == "a");
}

TEST_CASE("servers without JetStream are for a person") {
  NatsServers servers{{.servers = 1, .jetstream = false}};
  const auto log = open_log(servers.url_list(), test_names());
  const auto state = log->state();
  REQUIRE_FALSE(state);
  CHECK(state.error().kind != Kind::other);
  CHECK_FALSE(log->publish(bytes_of("a")));
}

TEST_CASE("a stream that was deleted and made anew is another one") {
  OneServer one;
  make_stream(one.servers, one.names, 1);
  const auto log = open_log(one.servers.url_list(), one.names);
  REQUIRE(log->state());
  publish(*log, "a");
  publish(*log, "b");
  CHECK(read(*log, 0) == "a");
  CHECK(read(*log, 1) == "b");
  ask(one.servers, "$JS.API.STREAM.DELETE." + one.names.stream);
  make_stream(one.servers, one.names, 1);

  CHECK(publish_failure(*log).kind == Kind::other);
  CHECK(read_failure(*log, 2).kind == Kind::other);
  const auto state = log->state();
  REQUIRE_FALSE(state);
  CHECK(state.error().kind == Kind::other);
  // The one message by which it was found out, and none since.
  for (int i = 0; i < 5; ++i) CHECK(publish_failure(*log).kind == Kind::other);
  const auto other = open_log(one.servers.url_list(), one.names);
  const auto in_it = other->state();
  REQUIRE(in_it);
  CHECK(in_it->last <= 1);
}

TEST_CASE("a server that is deleted with its files, and comes back empty, is noticed") {
  OneServer one;
  make_stream(one.servers, one.names, 1);
  const auto log = open_log(one.servers.url_list(), one.names);
  publish(*log, "a");
  CHECK(read(*log, 0) == "a");
  one.servers.kill(0);
  one.servers.lose_files(0);
  one.servers.start(0);
  CHECK(read_failure(*log, 1).kind == Kind::refused);
}

TEST_CASE("when the stream took a message is the same for all who ask, and is not the publisher's to say") {
  OneServer one;
  auto settings = wanted_settings(one.names, 1);
  settings["max_msgs"] = 3;
  ask(one.servers, "$JS.API.STREAM.CREATE." + one.names.stream, settings.dump());
  const auto log = open_log(one.servers.url_list(), one.names);
  const auto time_of = [](LogStream& of, std::uint64_t sequence) {
    const auto until = from_now(kPatience);
    for (;;) {
      const auto time_ms = of.time_of(sequence);
      if (time_ms || time_ms.error().kind != Kind::unavailable) return time_ms;
      REQUIRE(std::chrono::steady_clock::now() < until);
    }
  };
  const auto now_ms = [] {
    return std::chrono::duration_cast<std::chrono::milliseconds>(
               std::chrono::system_clock::now().time_since_epoch())
        .count();
  };
  const std::int64_t before_ms = now_ms();
  publish(*log, "a");
  send_as_stream(one.servers, one.names.log, one.names.stream, 999, "b");
  publish(*log, "c");
  const std::int64_t after_ms = now_ms();
  std::int64_t last_ms = before_ms;
  const auto other = open_log(one.servers.url_list(), one.names);
  for (std::uint64_t sequence = 1; sequence <= 3; ++sequence) {
    const auto time_ms = time_of(*log, sequence);
    REQUIRE(time_ms.has_value());
    CHECK(*time_ms >= last_ms);
    CHECK(*time_ms <= after_ms);
    CHECK(time_of(*other, sequence).value_or(0) == *time_ms);
    last_ms = *time_ms;
  }
  CHECK(log->time_of(4).error().kind == Kind::unavailable);
  publish(*log, "d");
  CHECK(time_of(*log, 1).error().kind == Kind::gone);
}

TEST_CASE("a message of any size reaches all who read, cut where no talusd would read on") {
  OneServer one("max_payload: 4MB");
  auto settings = wanted_settings(one.names, 1);
  settings["max_msg_size"] = -1;
  ask(one.servers, "$JS.API.STREAM.CREATE." + one.names.stream, settings.dump());
  const auto log = open_log(one.servers.url_list(), one.names);
  publish(*log, "a");
  CHECK(read(*log, 0) == "a");
  const auto somebody = connected_to(one.servers.url_list());
  REQUIRE(somebody->publish(one.names.log, bytes_of(std::string(3U << 20U, 'x')), 5s));
  publish(*log, "c");
  CHECK(read(*log, 1).size() == kStreamMessageBytes + 1);
  CHECK(read(*log, 2) == "c");
}

TEST_CASE("messages that the stream no longer keeps are gone") {
  OneServer one;
  auto settings = wanted_settings(one.names, 1);
  settings["max_msgs"] = 10;
  ask(one.servers, "$JS.API.STREAM.CREATE." + one.names.stream, settings.dump());
  const auto log = open_log(one.servers.url_list(), one.names);
  for (int i = 0; i < 20; ++i) publish(*log, "a");
  const auto failure = read_failure(*log, 3);
  CHECK(failure.kind == Kind::gone);
  CHECK_THAT(failure.reason, Catch::Contains("from 11 on") && Catch::Contains("message 4"));
  CHECK(read(*log, 10) == "a");
}

TEST_CASE("another stream that took the subject is refused by name") {
  OneServer one;
  ask(one.servers, "$JS.API.STREAM.CREATE.FOREIGN",
      R"({"name":"FOREIGN","subjects":["talus.>"],"storage":"file"})");
  const auto log = open_log(one.servers.url_list(), one.names);
  const auto failure = publish_failure(*log);
  CHECK(failure.kind == Kind::refused);
  CHECK_THAT(failure.reason, Catch::Contains("FOREIGN"));
}

TEST_CASE("a publisher's headers do not stand for those of NATS") {
  OneServer one;
  make_stream(one.servers, one.names, 1);
  const auto log = open_log(one.servers.url_list(), one.names);
  publish(*log, "a");
  CHECK(read(*log, 0) == "a");
  send_as_stream(one.servers, one.names.log, "OTHER", 999, "b");
  publish(*log, "c");
  CHECK(read(*log, 1) == "b");
  CHECK(read(*log, 2) == "c");
  // By number, as it is no more to be had by the tail.
  const auto late = open_log(one.servers.url_list(), one.names);
  CHECK(read(*late, 0) == "a");
  CHECK(read(*late, 1) == "b");
  CHECK(read(*late, 2) == "c");
}

TEST_CASE("false messages on the tail subject do no harm after the true ones, and are found before them") {
  OneServer one("max_payload: 64MB");
  make_stream(one.servers, one.names, 1);
  const auto log = open_log(one.servers.url_list(), one.names);
  publish(*log, "a");
  CHECK(read(*log, 0) == "a");
  const auto attacker = connected_to(one.servers.url_list());
  const auto forge = [&](const std::string& stream, std::uint64_t sequence, std::string_view text) {
    send_as_stream(one.servers, one.names.tail, stream, sequence, text);
  };

  SECTION("of another stream, without a number, too large, of a far number, or of one that was read") {
    REQUIRE(attacker->send(one.names.tail, "nowhere", "no header"));
    forge("OTHER", 2, "false");
    forge(one.names.stream, 0, "false");
    forge(one.names.stream, 1'000'000'000'000, "false");
    forge(one.names.stream, 1, "false");
    const auto until = from_now(kPatience);
    forge(one.names.stream, 2, std::string(16U << 20U, 'x'));
    while (log->figures().false_messages < 4) {
      REQUIRE(std::chrono::steady_clock::now() < until);
      REQUIRE(log->next(1, from_now(10ms)));
    }
    // NATS may end the connection of who does not send or take it at once.
    try {
      forge(one.names.stream, 2, std::string(60U << 20U, 'x'));
    } catch (const std::runtime_error& ended) {
      WARN(ended.what());
    }
    publish(*log, "b");
    CHECK(read(*log, 1) == "b");
    publish(*log, "c");
    std::uint64_t after = 1;
    std::string text;
    do text = read(*log, after++);
    while (text == "b");  // twice, where its first acknowledgement did not come
    CHECK(text == "c");
  }
  SECTION("in place of the next one") {
    forge(one.names.stream, 2, "false");
    CHECK(read(*log, 1) == "false");
    SECTION("and another server publishes") {
      const auto other = open_log(one.servers.url_list(), one.names);
      publish(*other, "b");
      const auto failure = read_failure(*log, 2);
      CHECK(failure.kind == Kind::false_message);
      CHECK_THAT(failure.reason, Catch::Contains(one.names.tail));
      CHECK(publish_failure(*log).kind == Kind::false_message);
    }
    SECTION("and this one does") {
      (void)log->publish(bytes_of("b"));  // may fail by the same
      const auto failure = read_failure(*log, 2);
      CHECK((failure.kind == Kind::other || failure.kind == Kind::false_message));
      CHECK_THAT(failure.reason, Catch::Contains(one.names.tail));
    }
  }
}

TEST_CASE("who may not come in is told so, and comes in once he may") {
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
  OneServer one{talusd_permissions(true)};
  make_stream(one.servers, one.names, 1);
  const auto log = open_log(one.servers.url_list(), one.names, as_talusd());
  publish(*log, "a");
  CHECK(read(*log, 0) == "a");
  REQUIRE(log->state());
  one.servers.reconfigure(talusd_permissions(false));
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
  one.servers.reconfigure(talusd_permissions(true));
  const auto until = from_now(kPatience);
  while (!log->state()) REQUIRE(std::chrono::steady_clock::now() < until);
  CHECK(log->time_of(1));
  CHECK(log->state());
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
  SECTION("the server's certificate is that of cluster.ca, and of its name") {
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

TEST_CASE("of three servers the leader dies: nothing that was acknowledged is lost, and it goes on") {
  NatsServers servers;
  const StreamNames names = test_names();
  make_stream(servers, names, 3);
  const auto log = open_log(servers.url_list(), names);
  const auto other = open_log(servers.url_list(), names);
  std::set<std::string> acknowledged;
  const auto publish_some = [&](int from, int to) {
    for (int i = from; i < to; ++i) {
      const std::string text = std::to_string(i);
      publish(*log, text);
      acknowledged.insert(text);
    }
  };
  publish_some(0, 50);
  servers.kill(servers.leader_of(names.stream));
  publish_some(50, 100);
  std::uint64_t after = 0;
  int newest = -1;
  while (!acknowledged.empty()) {
    const std::string text = read(*other, after++);
    acknowledged.erase(text);
    // A message may be there twice, where its first acknowledgement did not come; never out of order.
    CHECK(std::stoi(text) >= newest);
    newest = std::stoi(text);
  }
}

TEST_CASE("a frozen server is left for another one") {
  NatsServers servers;
  const StreamNames names = test_names();
  make_stream(servers, names, 3);
  const auto log = open_log(servers.url_list(), names);
  publish(*log, "a");
  for (std::size_t server = 0; server < servers.count(); ++server) {
    servers.freeze(server);
    publish(*log, "b");
    servers.go_on(server);
    servers.await_ready();
    servers.await_replicas(names.stream);
  }
  CHECK(read(*log, 0) == "a");
}
