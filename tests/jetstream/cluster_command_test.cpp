// What "talusd cluster" makes and finds, at real nats-servers.
#include <algorithm>
#include <chrono>
#include <string>
#include <thread>

#include <xxhash.h>
#include <asio/ip/tcp.hpp>
#include <asio/read_until.hpp>
#include <asio/write.hpp>
#include <catch2/catch.hpp>

#include <talus/store/bytes.h>

#include "cluster/jetstream/stream_settings.h"
#include "commands/cluster/check.h"
#include "commands/cluster/connection_words.h"
#include "commands/cluster/init.h"
#include "commands/cluster/nats_greeting.h"
#include "commands/cluster/replica_comparison.h"
#include "commands/cluster/status.h"
#include "opened_stream.h"
#include "scratch_directory.h"

using namespace talus::nats_test;
using namespace talus::server;
using namespace talus::server::cluster_tool;
using talus::ContentHash;

namespace {

Target target_at(const std::string& urls, std::uint64_t replicas, jetstream::Credentials who = {}) {
  return {urls_of(urls),     std::make_shared<const jetstream::Credentials>(std::move(who)),
          ContentHash{1, 0}, test_names(),
          replicas,          {}};
}

jetstream::Credentials user(const std::string& name, const std::string& password) {
  jetstream::Credentials who;
  who.user = name;
  who.password.emplace(password);
  return who;
}

cluster::Genesis genesis_of(std::uint64_t world = 7) {
  cluster::Genesis genesis;
  genesis.identity = {ContentHash{1, 0}, ContentHash{world, 0}};
  return genesis;
}

/// As a message of a newer talusd.
talus::store::Bytes of_newer_format(talus::store::Bytes message) {
  message.at(0) = std::byte{9};
  message.resize(message.size() - cluster::kSealBytes);
  talus::store::ByteWriter{message}.fixed64(XXH3_64bits(message.data(), message.size()));
  return message;
}

/// Gives the stream this description, as an admin's tool does.
void describe(jetstream::Connection& connection, const Target& target, const std::string& description) {
  nlohmann::json settings = jetstream::wanted_settings(target.names, 1);
  settings["description"] = description;
  const auto reply = connection.request("$JS.API.STREAM.UPDATE." + target.names.stream, settings.dump(),
                                        std::chrono::seconds{10});
  REQUIRE(reply);
  CHECK_FALSE(nlohmann::json::parse(jetstream::ReceivedMessage{reply->get()}.text()).contains("error"));
}

std::string lines_of(const Target& target, const cluster::Genesis& genesis) {
  return finding_lines(check(target, genesis));
}

/// Lines that begin with "fault".
std::string faults_of(const Target& target, const cluster::Genesis& genesis = genesis_of()) {
  std::vector<Finding> findings = check(target, genesis);
  std::erase_if(findings, [](const Finding& finding) { return finding.kind != Finding::Kind::fault; });
  return finding_lines(findings);
}

}  // namespace

TEST_CASE("init makes the stream and its first message once, and finds them again") {
  NatsServers servers{{.servers = 1}};
  const Target target = target_at(servers.url_list(), 1);
  const auto made = init(target, genesis_of());
  INFO((made ? "" : made.error()));
  REQUIRE(made);
  CHECK(made->stream);
  CHECK(made->genesis);
  CHECK_THAT(made_lines(target, genesis_of(), *made), Catch::Contains(to_string(target.store_id)));

  const auto again = init(target, genesis_of());
  REQUIRE(again);
  CHECK_FALSE(again->stream);
  CHECK_FALSE(again->genesis);

  const auto log = open_log(servers.url_list(), target.names);
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds{30};
  const auto first = log->next(0, until);
  REQUIRE(first);
  REQUIRE(*first);
  const auto read = cluster::decode_genesis((*first)->bytes);
  REQUIRE(read);
  CHECK(*read == genesis_of());
  CHECK(log->state()->last == 1);

  CHECK(faults_of(target).empty());
  const auto other_world = init(target, genesis_of(8));
  REQUIRE_FALSE(other_world);
  CHECK_THAT(other_world.error(), Catch::Contains("world"));
  CHECK_THAT(faults_of(target, genesis_of(8)), Catch::Contains(to_string(ContentHash{8, 0})));
}

TEST_CASE("init goes on where it was cut off between the stream and its first message") {
  NatsServers servers{{.servers = 1}};
  const Target target = target_at(servers.url_list(), 1);
  make_stream(servers, target.names, 1);
  const auto made = init(target, genesis_of());
  REQUIRE(made);
  CHECK_FALSE(made->stream);
  CHECK(made->genesis);
}

TEST_CASE("init refuses a stream of other settings by their names, and changes nothing") {
  NatsServers servers{{.servers = 1}};
  const Target target = target_at(servers.url_list(), 1);
  auto settings = jetstream::wanted_settings(target.names, 1);
  settings["max_age"] = 3'600'000'000'000;
  settings["deny_purge"] = false;
  ask(servers, "$JS.API.STREAM.CREATE." + target.names.stream, settings.dump());
  const auto made = init(target, genesis_of());
  REQUIRE_FALSE(made);
  CHECK_THAT(made.error(), Catch::Contains("deny_purge is false and should be true"));
  const std::string faults = faults_of(target);
  CHECK_THAT(faults, Catch::Contains("deny_purge is false and should be true"));
  CHECK_THAT(faults, Catch::Contains("max_age is 3600000000000 and should be 604800000000000") &&
                         Catch::Contains("peer"));
}

TEST_CASE("after init and check, each given twice, replicas that are killed and start again stay the same") {
  NatsServers servers;
  const Target target = target_at(servers.url_list(), 3);
  const std::string& stream = target.names.stream;
  for (int i = 0; i < 2; ++i) {
    REQUIRE(init(target, genesis_of()));
    CHECK(faults_of(target).empty());
  }
  const auto connection = connected_to(servers.url_list());
  const cluster::BatchHead head{genesis_of().identity, 1, 1, 0, 0, {}};
  for (int i = 0; i < 5; ++i) {
    REQUIRE(connection->publish(target.names.log, cluster::encode_batch(head, nullptr, {}),
                                std::chrono::seconds{10}));
  }
  servers.await_replicas(stream);
  const std::size_t leader = servers.leader_of(stream);
  for (std::size_t server = 0; server < servers.count(); ++server) {
    if (server == leader) continue;
    servers.kill(server);
    servers.start(server);
    servers.await_ready();
    servers.await_replicas(stream);
  }
  CHECK(last_of_each(servers, stream) == std::vector<std::uint64_t>{6, 6, 6});
}

TEST_CASE("replicas are compared by what they answer, and by nothing else") {
  using Texts = std::map<std::uint64_t, std::string>;
  const Texts right{{1, "a"}, {2, "b"}, {3, "c"}};
  std::vector<Texts> replicas{right, right, right};
  jetstream::StreamInfo info;
  info.leader = "n1";
  info.state.first = 1;
  info.state.last = 3;
  info.replicas = {{"n2", true, false, 0, {}}, {"n3", true, false, 0, {}}};
  std::size_t asked = 0;
  int pauses = 0;
  ReplicaQuestions questions;
  questions.ask = [&](const std::string& question) -> tl::expected<ReplicaAnswer, std::string> {
    const Texts& replica = replicas[asked++ % replicas.size()];
    const auto json = nlohmann::json::parse(question);
    const std::uint64_t sequence =
        json.contains("seq") ? json.at("seq").get<std::uint64_t>() : replica.rbegin()->first;
    const auto found = replica.find(sequence);
    if (found == replica.end()) return ReplicaAnswer{};
    return ReplicaAnswer{sequence, found->second};
  };
  questions.info = [&] { return std::optional{info}; };
  questions.pause = [&] { ++pauses; };
  const auto compared = [&] { return compare_replicas(questions, test_names()); };

  CHECK(compared().value().empty());
  SECTION("another message") {
    replicas[1][3] = "d";
    CHECK(compared().value() == std::vector<std::string>{"message 3 is not the same at all replicas"});
  }
  SECTION("one too many") {
    replicas[2][4] = "c";
    CHECK(compared().value() ==
          std::vector<std::string>{"one replica has message 4, and the leader ends at 3"});
  }
  SECTION("one too few, though NATS calls it current") {
    replicas[2].erase(3);
    CHECK(compared().value() == std::vector<std::string>{"not all replicas have message 3"});
  }
  SECTION("one that lags behind is not compared") {
    replicas[2].erase(3);
    info.replicas[1].lag = 1;
    CHECK_THAT(compared().error(), Catch::Contains("lags behind"));
  }
  SECTION("one that comes after it is asked is right") {
    replicas[2].erase(3);
    questions.pause = [&] { replicas[2][3] = "c"; };
    CHECK(compared().value().empty());
  }
  SECTION("no answer") {
    questions.ask = [&](const std::string&) -> tl::expected<ReplicaAnswer, std::string> {
      ++asked;
      return tl::unexpected{std::string{"no replica answers (status 503)"}};
    };
    asked = 0;
    CHECK(compared().error() == "no replica answers (status 503)");
    CHECK(asked == 3);
  }
  SECTION("no leader") {
    replicas[2].erase(3);
    info.leader.clear();
    CHECK(compared().error() == "the stream has no leader");
  }
  SECTION("the leader does not answer") {
    questions.info = [] { return std::nullopt; };
    CHECK_FALSE(compared());
  }
}

TEST_CASE("check finds that a replica holds other messages, though NATS calls it current") {
  NatsServers servers;
  const Target target = target_at(servers.url_list(), 3);
  const std::string& stream = target.names.stream;
  REQUIRE(init(target, genesis_of()));
  cluster::BatchHead head{genesis_of().identity, 1, 1, 0, 0, {}};
  const auto publish = [&] {
    ++head.number;  // no two are the same
    REQUIRE(
        connected_to(servers.url(servers.leader_of(stream)))
            ->publish(target.names.log, cluster::encode_batch(head, nullptr, {}), std::chrono::seconds{10}));
  };
  for (int i = 0; i < 3; ++i) publish();
  servers.await_replicas(stream);
  CHECK_THAT(lines_of(target, genesis_of()),
             Catch::Contains("ok: all replicas that answer have the same newest"));
  publish_to_be_refused(servers, target.names.log, "no");
  for (int i = 0; i < 3; ++i) publish();
  servers.await_replicas(stream);
  const std::size_t wrong = (servers.leader_of(stream) + 1) % servers.count();
  servers.kill(wrong);
  servers.start(wrong);
  servers.await_ready();
  servers.await_replicas(stream);
  const std::vector<std::uint64_t> last = last_of_each(servers, stream);
  if (std::ranges::count(last, last.front()) == 3) {
    WARN("this nats-server takes no message twice: nothing to find");
    return;
  }
  CHECK_THAT(lines_of(target, genesis_of()),
             Catch::Contains("ok: leader n") && Catch::Contains("all 3 replicas current"));
  CHECK_THAT(faults_of(target),
             Catch::Contains("the replicas differ: one replica has message 8, and the leader ends at 7"));
  publish();  // as message 8, which is another there
  CHECK_THAT(faults_of(target),
             Catch::Contains("the replicas differ: message 8 is not the same at all replicas"));
}

TEST_CASE("three replicas where there is one server are refused with what is missing") {
  NatsServers servers{{.servers = 1}};
  const auto made = init(target_at(servers.url_list(), 3), genesis_of());
  REQUIRE_FALSE(made);
  CHECK_THAT(made.error(), Catch::Contains("replicas"));
}

TEST_CASE("check names servers that cannot be reached, want other credentials, or have no JetStream") {
  NatsServers servers{{.servers = 1, .more = "authorization { user: talus, password: right }"}};
  CHECK_THAT(faults_of(target_at(servers.url_list(), 1, user("talus", "wrong"))),
             Catch::Contains(servers.url(0)) && Catch::Contains("uthorization"));
  servers.kill(0);
  CHECK_THAT(faults_of(target_at(servers.url_list(), 1)),
             Catch::Contains(servers.url(0)) && Catch::Contains("refused"));
  NatsServers plain{{.servers = 1, .jetstream = false}};
  const std::string faults = faults_of(target_at(plain.url_list(), 1));
  CHECK_THAT(faults, Catch::Contains(plain.url(0)) && Catch::Contains("JetStream is off"));
}

TEST_CASE("check says that the stream is missing, and how to make it") {
  NatsServers servers{{.servers = 1}};
  CHECK_THAT(faults_of(target_at(servers.url_list(), 1)), Catch::Contains("talusd cluster init"));
}

TEST_CASE("check and init name a small max_payload") {
  NatsServers servers{{.servers = 1, .more = "max_payload: 64KB"}};
  const std::string fault = servers.url(0) + ": max_payload of nats-server is 65536";
  CHECK_THAT(faults_of(target_at(servers.url_list(), 1)), Catch::Contains(fault));
  const auto made = init(target_at(servers.url_list(), 1), cluster::Genesis{});
  REQUIRE_FALSE(made);
  CHECK_THAT(made.error(), Catch::Contains(fault));
}

TEST_CASE("check names each missing permission, and one too many") {
  const std::string id = test_names().log.substr(0, test_names().log.rfind('.'));
  const auto with = [&](const std::string& publish, const std::string& subscribe) {
    return "authorization { users = [ { user: all, password: p }, { user: talus, password: p, permissions: { "
           "publish: " +
           publish + ", subscribe: " + subscribe + " } } ] }";
  };
  const std::string info = "\"$JS.API.STREAM.INFO.>\"";
  const std::string get = "\"$JS.API.STREAM.MSG.GET.>\", \"$JS.API.DIRECT.GET.>\"";
  const std::string log = "\"" + id + ".log\"";
  const auto faults = [&](const std::string& publish, const std::string& subscribe) {
    NatsServers servers{{.servers = 1, .more = with(publish, subscribe)}};
    const auto made = init(target_at(servers.url_list(), 1, user("all", "p")), genesis_of());
    REQUIRE(made);
    return lines_of(target_at(servers.url_list(), 1, user("talus", "p")), genesis_of());
  };
  const std::string tail = "[\"_INBOX.>\", \"" + id + ".tail\"]";
  SECTION("all that is wanted and no more") {
    const std::string lines = faults("[" + info + "," + get + "," + log + "]", tail);
    CHECK_THAT(lines, !Catch::Contains("fault: ") && !Catch::Contains("may publish to " + id + ".tail"));
  }
  SECTION("no stream info") {
    CHECK_THAT(faults("[" + get + "," + log + "]", tail),
               Catch::Contains("fault: ") && Catch::Contains("$JS.API.STREAM.INFO"));
  }
  SECTION("no publishing") {
    CHECK_THAT(faults("[" + info + "," + get + "]", tail),
               Catch::Contains("fault: cannot publish to " + id + ".log"));
  }
  SECTION("no messages") {
    CHECK_THAT(faults("[" + info + "," + log + "]", tail),
               Catch::Contains("fault: ") && Catch::Contains("$JS.API.STREAM.MSG.GET"));
  }
  SECTION("no tail") {
    CHECK_THAT(faults("[" + info + "," + get + "," + log + "]", "\"_INBOX.>\""),
               Catch::Contains("fault: cannot subscribe to " + id + ".tail"));
  }
  SECTION("publishing to the tail") {
    CHECK_THAT(faults("\">\"", tail), Catch::Contains("note: may publish to " + id + ".tail"));
  }
}

TEST_CASE("check reads the newest messages, and names the messages that servers pass over or stop at") {
  NatsServers servers{{.servers = 1}};
  const Target target = target_at(servers.url_list(), 1);
  REQUIRE(init(target, genesis_of()));
  const auto connection = connected_to(servers.url_list());
  const auto publish = [&](std::span<const std::byte> bytes) {
    REQUIRE(connection->publish(target.names.log, bytes, std::chrono::seconds{10}));
  };
  const cluster::BatchHead head{genesis_of().identity, 1, 1, 0, 0, {}};
  publish(bytes_of("hello"));
  publish(cluster::encode_batch(head, nullptr, {}));
  std::string lines = lines_of(target, genesis_of());
  CHECK_THAT(lines,
             Catch::Contains("note: message 2: it was not written by a talusd; all servers pass over it") &&
                 !Catch::Contains("fault: "));
  // None but the newest.
  CHECK_THAT(finding_lines(check(target, genesis_of(), 1)),
             Catch::Contains("ok: messages 3 to 3 can be read") && !Catch::Contains("note: message"));
  publish(of_newer_format(cluster::encode_batch(head, nullptr, {})));
  CHECK_THAT(
      lines_of(target, genesis_of()),
      Catch::Contains("note: message 4: it has format 9; this talusd reads up to 1; all servers pass") &&
          !Catch::Contains("fault: "));
  describe(*connection, target, "log format 2 from message 4");
  CHECK_THAT(faults_of(target),
             Catch::StartsWith("fault: message 4: it has format 9; this talusd reads up to 1; a talusd of "
                               "this version stops before it; upgrade it"));
  for (int i = 0; i < 12; ++i) publish(bytes_of("hello"));
  CHECK_THAT(lines_of(target, genesis_of()), Catch::Contains("note: 4 more messages cannot be read"));
}

TEST_CASE("status and check say which formats are enabled, and that they do not understand it") {
  NatsServers servers{{.servers = 1}};
  const Target target = target_at(servers.url_list(), 1);
  REQUIRE(init(target, genesis_of()));
  const auto connection = connected_to(servers.url_list());
  const auto status = [&] {
    auto read = read_status(target);
    REQUIRE(read);
    return *std::move(read);
  };
  const auto json = [&] { return nlohmann::json::parse(status_json(status())).at("log_format"); };
  CHECK_THAT(status_lines(status()), Catch::Contains("\nlog format 1\n"));
  CHECK(json() == nlohmann::json::parse(R"({"reads": 1, "understood": true, "enabled": []})"));
  CHECK_THAT(lines_of(target, genesis_of()),
             Catch::Contains("ok: " + target.names.stream + ": log format 1\n"));

  describe(*connection, target, "log format 2 from message 40, 3 from message 50");
  const std::string what = "log format 2 from message 40, 3 from message 50; this talusd reads up to 1";
  CHECK_THAT(status_lines(status()), Catch::Contains("\n" + what));
  CHECK(json() == nlohmann::json::parse(
                      R"({"reads": 1, "understood": true,
                          "enabled": [{"format": 2, "from": 40}, {"format": 3, "from": 50}]})"));
  CHECK_THAT(lines_of(target, genesis_of()),
             Catch::Contains("note: " + target.names.stream + ": " + what) && !Catch::Contains("fault: "));

  describe(*connection, target, "log format 2 from message 40.");
  const std::string other = "log format NOT understood: \"log format 2 from message 40.\"";
  CHECK_THAT(status_lines(status()), Catch::Contains("\n" + other + "\n"));
  CHECK_FALSE(json().at("understood").get<bool>());
  CHECK_THAT(faults_of(target), Catch::StartsWith("fault: " + target.names.stream + ": " + other));
}

TEST_CASE("check says of a genesis that a newer talusd wrote to upgrade this one") {
  NatsServers servers{{.servers = 1}};
  const Target target = target_at(servers.url_list(), 1);
  make_stream(servers, target.names, 1);
  const auto genesis = cluster::encode(genesis_of());
  REQUIRE(genesis);
  REQUIRE(connected_to(servers.url_list())
              ->publish(target.names.log, of_newer_format(*genesis), std::chrono::seconds{10}));
  CHECK_THAT(faults_of(target),
             Catch::Contains("message 1: it has format 9; this talusd reads up to 1; upgrade it"));
}

TEST_CASE("one lost server of three is a note and two are a fault") {
  NatsServers servers;
  const Target target = target_at(servers.url_list(), 3);
  REQUIRE(init(target, genesis_of()));
  servers.await_replicas(target.names.stream);
  std::string lines = lines_of(target, genesis_of());
  CHECK_THAT(lines, !Catch::Contains("fault: ") && Catch::Contains("all 3 replicas current") &&
                        Catch::Contains("note: nats-server 2.9"));
  auto status = read_status(target);
  REQUIRE(status);
  CHECK(status->info.replicas.size() == 2);
  CHECK_THAT(status_lines(*status), Catch::Contains("leader n") && Catch::Contains("messages 1 to 1"));
  CHECK_THAT(status_json(*status), Catch::Contains("\"last\": 1"));

  servers.kill((servers.leader_of(target.names.stream) + 1) % 3);
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds{30};
  do {
    lines = lines_of(target, genesis_of());
    REQUIRE(std::chrono::steady_clock::now() < until);
  } while (lines.find("2 of 3 replicas are current") == std::string::npos);
  servers.kill(servers.leader_of(target.names.stream));
  lines = lines_of(target, genesis_of());
  CHECK_THAT(lines, Catch::Contains("fault: ") && Catch::Contains("refused"));
}

TEST_CASE("a NATS server's greeting is read, and nothing else is taken for one") {
  const auto greeting = parse_greeting(
      R"(INFO {"server_name":"n1","version":"2.9.10","jetstream":true,"max_payload":1048576,"tls_required":true} )");
  REQUIRE(greeting);
  CHECK(greeting->name == "n1");
  CHECK(greeting->jetstream);
  CHECK(greeting->tls);
  CHECK(at_least(greeting->version, 2, 9));
  CHECK_FALSE(at_least(greeting->version, 2, 10));
  CHECK(at_least("2.10.1", 2, 10));
  CHECK(at_least("3.0", 2, 10));
  CHECK_FALSE(at_least("x", 2, 9));
  for (const auto* line : {"", "HTTP/1.1 200 OK", "INFO", "INFO []", "INFO {", R"(INFO {"max_payload":1})",
                           R"(INFO {"version":"2.9.10","max_payload":"1"})"}) {
    const auto refused = parse_greeting(line);
    REQUIRE_FALSE(refused);
    // What it says, and what is to be done.
    CHECK_THAT(refused.error(), Catch::Contains("not a NATS server: it sent \"") && Catch::Contains("4222"));
  }
}

TEST_CASE("check says what answers in place of NATS") {
  asio::io_context io;
  asio::ip::tcp::acceptor acceptor{io, {asio::ip::address_v4::loopback(), 0}};
  std::thread http{[&] {
    // Nothing until it is asked, as HTTP has it: who asks first gets no answer.
    for (std::error_code failed; !failed;) {
      asio::ip::tcp::socket socket = acceptor.accept(failed);
      if (failed) return;
      std::string request;
      asio::read_until(socket, asio::dynamic_buffer(request, 1'000), "\r\n\r\n", failed);
      if (!failed) asio::write(socket, asio::buffer(std::string{"HTTP/1.0 200 OK\r\n\r\n"}), failed);
      failed.clear();
      if (!request.empty()) return;
    }
  }};
  const auto url = "nats://127.0.0.1:" + std::to_string(acceptor.local_endpoint().port());
  const auto answer = greeting_of(url, std::chrono::milliseconds{500});
  http.join();
  REQUIRE_FALSE(answer);
  CHECK_THAT(answer.error(),
             Catch::Contains("not a NATS server: it sent \"HTTP/1.0 200 OK\"") && Catch::Contains("4222"));
}

TEST_CASE("an error of TLS names the setting at fault") {
  using jetstream::Credentials;
  Greeting greeting;
  greeting.tls = greeting.tls_verify = true;
  Credentials who;
  who.tls = true;
  who.certificate = "a certificate";
  const auto words = [&](std::string_view reason) {
    return connection_words("tls://a:1", "tls://a:1: " + std::string{reason}, greeting, who);
  };
  CHECK_THAT(words("SSL handshake error: 20:unable to get local issuer certificate:depth=0"),
             Catch::StartsWith("tls://a:1: cluster.ca: ") && Catch::EndsWith("depth=0)"));
  CHECK_THAT(words("SSL handshake error: 64:IP address mismatch"),
             Catch::StartsWith("tls://a:1: cluster.nats: "));
  CHECK_THAT(words("Error using private key: key values mismatch"),
             Catch::StartsWith("tls://a:1: cluster.key: "));
  CHECK_THAT(words("Expected 'PONG', got ''"), Catch::StartsWith("tls://a:1: cluster.certificate: "));
  CHECK(words("Authorization Violation") == "tls://a:1: Authorization Violation");
  who.certificate.clear();
  CHECK_THAT(words("Expected 'PONG', got ''"),
             Catch::Contains("cluster.certificate, cluster.key: are not set"));
  who.tls = false;
  CHECK_THAT(words("unable to get local issuer certificate"), Catch::Contains("write tls://"));
  greeting.tls = false;
  who.tls = true;
  CHECK_THAT(words("whatever"), Catch::Contains("write nats://"));
}

TEST_CASE("metrics of the cluster are found in a page") {
  const auto found = cluster_metrics(
      "# HELP talus_cluster_sequence x\ntalus_cluster_sequence 12\ntalus_x 1\n"
      "talus_cluster_publish_seconds_bucket{le=\"1\"} 3\ntalus_cluster_connected 1");
  CHECK(found == std::map<std::string, double>{{"sequence", 12}, {"connected", 1}});
}

TEST_CASE("the store is the named one, or the data directory's") {
  const ScratchDirectory scratch;
  Config config;
  config.cluster.nats = urls_of("nats://127.0.0.1:1");
  CHECK_THAT(Target::of(config).error(), Catch::StartsWith("cluster.store: "));
  REQUIRE(Target::for_init(config));
  CHECK(Target::for_init(config)->store_id != Target::for_init(config)->store_id);

  const ContentHash id{5, 6};
  scratch.write("store.toml", talus::store::store_text({id, ContentHash{7, 0}}));
  config.data = scratch.path();
  REQUIRE(Target::of(config));
  CHECK(Target::of(config)->store_id == id);
  CHECK_THAT(Target::for_init(config).error(), Catch::Contains("join-cluster"));
  config.cluster.store = to_string(id);
  CHECK(Target::for_init(config));
  config.cluster.store = to_string(ContentHash{1, 1});
  CHECK_THAT(Target::of(config).error(), Catch::StartsWith("cluster.store: "));
}
