// Servers that have no store, or one that is too old or wrong, and get one.
#include <unistd.h>

#include <random>

#include "held_port.h"
#include "joining_servers.h"

using namespace talus;
using namespace talus::e2e;

TEST_CASE("an empty disk joins while edits flow, and has the same store then") {
  JoiningServers servers;
  servers.begin("a");
  const auto a = servers.start(servers.settings("a"));
  Builder builder{servers, a->port()};
  await("edits", [&] { return builder.done() > 20; });
  servers.forget(5);
  Settings settings = servers.joiner("b", {a->admin_port()});
  SECTION("of a store that is named") {}
  SECTION("of whichever store peers have") {
    settings["TALUS_CLUSTER_STORE"] = "";
  }
  const auto b = servers.start(settings);
  await("readiness", [&] { return JoiningServers::is_ready(*b); });
  const int when_joined = builder.done();
  await("edits after it joined", [&] { return builder.done() > when_joined + 20; });
  builder.stop();
  servers.await_same("a", "b");
  // Its own edits are the other's.
  servers.build(b->port(), 5);
  servers.await_same("b", "a");
  CHECK(HttpClient{a->admin_port()}.get("/metrics").body.find("talus_checkpoints_sent_total 1") !=
        std::string::npos);
}

TEST_CASE("an empty disk needs no peer where the stream goes back to an empty store") {
  JoiningServers servers;
  servers.begin("a", 0);
  const auto a = servers.start(servers.settings("a"));
  servers.build(a->port(), 10);
  const auto b = servers.start(servers.settings("b"));
  await("readiness", [&] { return JoiningServers::is_ready(*b); });
  servers.await_same("a", "b");
}

TEST_CASE("a server that was away for longer than the stream keeps takes a peer's store by itself") {
  JoiningServers servers;
  servers.begin("a");
  const auto a = servers.start(servers.settings("a"));
  {
    const auto b = servers.start(servers.joiner("b", {a->admin_port()}));
    await("readiness", [&] { return JoiningServers::is_ready(*b); });
  }
  servers.build(a->port(), 30);
  servers.forget();
  const auto b = servers.start(servers.joiner("b", {a->admin_port()}));
  await("readiness", [&] { return JoiningServers::is_ready(*b); });
  servers.await_same("a", "b");
  CHECK(fs::exists((servers.scratch / "b") / "rejoined-1"));
}

TEST_CASE("a running server that the stream has left behind ends with a status of its own, and joins anew") {
  JoiningServers servers;
  servers.begin("a");
  const auto a = servers.start(servers.settings("a"));
  auto b = servers.start(servers.joiner("b", {a->admin_port()}));
  await("readiness", [&] { return JoiningServers::is_ready(*b); });
  b->freeze();
  // What came meanwhile would wait in its socket.
  servers.nats->end(0);
  servers.nats->start(0);
  servers.nats->await_ready();
  servers.build(a->port(), 30);
  servers.forget();
  b->signal(SIGCONT);
  const ProgramResult ended = b->wait();
  CHECK(ended.status == 75);
  CHECK_THAT(ended.out, Catch::Contains("takes another server's store when it is started again"));
  b = servers.start(servers.joiner("b", {a->admin_port()}));
  await("readiness", [&] { return JoiningServers::is_ready(*b); });
  servers.await_same("a", "b");
}

TEST_CASE("servers that were all talked out of their stores recover by themselves") {
  JoiningServers servers;
  servers.begin("a");
  const nats_test::HeldPort one;
  const nats_test::HeldPort other;
  const auto ports = std::vector<std::uint16_t>{one.number(), other.number()};
  const auto start = [&](const std::string& data, std::size_t own) {
    return std::make_unique<ServerProcess>(
        servers.joiner(data, ports),
        std::vector<std::string>{"--admin", "127.0.0.1:" + std::to_string(ports[own])});
  };
  {
    const auto a = start("a", 0);
    const auto b = start("b", 1);
    await("readiness", [&] { return JoiningServers::is_ready(*b); });
    servers.build(a->port(), 5);
    servers.await_same("a", "b");
  }
  servers.scratch.write("a/rejoin", "most have another state");
  servers.scratch.write("b/rejoin", "most have another state");
  // Each prints where it listens once it has a store.
  std::unique_ptr<ServerProcess> a;
  std::thread first{[&] { a = start("a", 0); }};
  const auto b = start("b", 1);
  first.join();
  await("readiness", [&] { return JoiningServers::is_ready(*a) && JoiningServers::is_ready(*b); });
  servers.await_same("a", "b");
  servers.build(a->port(), 5);
  servers.await_same("a", "b");
  CHECK_FALSE(fs::exists((servers.scratch / "a") / "rejoin"));
  CHECK_FALSE(fs::exists((servers.scratch / "b") / "rejoin"));
}

TEST_CASE("a peer that dies in the middle leaves nothing half taken, and the next attempt succeeds") {
  JoiningServers servers;
  servers.begin("a", 5);
  Settings slow = servers.settings("a");
  slow["TALUS_RATES_CHECKPOINT_BYTES"] = "262144";
  {
    // More than one piece.
    const auto a = servers.start(servers.settings("a"));
    Player player;
    const auto world = player.connect(a->port());
    REQUIRE(world.has_value());
    std::vector<MaterialId> materials;
    for (const client::Material& material : world->materials) materials.push_back(material.id);
    std::mt19937_64 random{1};
    const auto place = [&] { return static_cast<std::int64_t>(random() % 64); };
    for (int i = 0; i < 600; ++i) {
      client::Edit edit;
      for (int j = 0; j < 1'500; ++j) {
        edit.writes.push_back(
            {{world->spawn.x + place(), world->spawn.y + 100 + i / 12, world->spawn.z + place()},
             materials[random() % materials.size()]});
      }
      REQUIRE(player.edit(std::move(edit)).has_value());
    }
  }
  auto a = servers.start(slow);
  servers.build(a->port(), 1);
  servers.forget();
  const Settings settings = servers.joiner("b", {a->admin_port()});
  const auto kill_and_return = [&](const ServerProcess& joiner) {
    // It comes, but not whole: it is paced.
    auto& b = const_cast<ServerProcess&>(joiner);
    (void)b.await_line("sends its store");
    const std::uint16_t port = a->admin_port();
    a->signal(SIGKILL);
    (void)a->wait();
    (void)b.await_line("the connection ended after");
    CHECK_FALSE(fs::exists(fs::path{servers.scratch / "b"} / "store.toml"));
    Settings again = servers.settings("a");
    a = std::make_unique<ServerProcess>(
        again, std::vector<std::string>{"--admin", "127.0.0.1:" + std::to_string(port)});
  };
  ServerProcess b{settings, {"--admin", "127.0.0.1:0"}, kill_and_return};
  await("readiness", [&] { return JoiningServers::is_ready(b); });
  servers.await_same("a", "b");
}

TEST_CASE(
    "a joiner without the right, or with another store's id, reports it and keeps asking, without a store") {
  JoiningServers servers;
  servers.begin("a");
  const auto a = servers.start(servers.settings("a"));
  servers.build(a->port(), 10);
  servers.forget();
  const std::vector<std::uint16_t> peers{a->admin_port()};
  Settings settings = servers.joiner("b", peers);
  std::string line;
  SECTION("no right") {
    settings = servers.joiner("b", peers, "player");
    line = "answers 403: the token lacks the right admin";
  }
  SECTION("no token of the peer's key") {
    servers.scratch.write("foreign", "eyJhbGciOiJIUzI1NiJ9.e30.c2lnbmF0dXJl");
    settings = servers.joiner("b", peers, "foreign");
    line = "answers 401: the token is not accepted";
  }
  SECTION("another world") {
    settings["TALUS_WORLD"] = "";
    line = "its store is of the world with fingerprint";
  }
  SECTION("another store") {
    servers.begin("c");
    {
      const auto c = servers.start(servers.settings("c"));
      servers.build(c->port(), 5);
    }
    servers.forget();
    settings["TALUS_CLUSTER_STORE"] = servers.store_id;
    line = "this server wants " + servers.store_id;
  }
  SECTION("no server") {
    settings = servers.joiner("b", {9});
    line = "no peer's store could be taken; all are asked again in 1000 ms";
  }
  settings["TALUS_LISTEN"] = "127.0.0.1:0";
  const ProgramResult ended = run_program("/usr/bin/timeout", {"4", TALUSD_PATH}, settings);
  CHECK_THAT(ended.out, Catch::Contains(line));
  CHECK_FALSE(fs::exists(fs::path{servers.scratch / "b"} / "store.toml"));
  CHECK(JoiningServers::is_ready(*a));
}

TEST_CASE("while a server joins its operators' port says so") {
  JoiningServers servers;
  servers.begin("a");
  const auto a = servers.start(servers.settings("a"));
  servers.build(a->port(), 10);
  servers.forget();
  const std::uint16_t port = a->admin_port();
  a->signal(SIGKILL);
  (void)a->wait();
  // Known before it listens, another one for each process of tests that run at once, and none that the system
  // gives out.
  const auto own = static_cast<std::uint16_t>(10'000 + ::getpid() % 10'000);
  std::unique_ptr<ServerProcess> again;
  const auto look = [&](const ServerProcess& joiner) {
    auto& b = const_cast<ServerProcess&>(joiner);
    (void)b.await_line("all are asked again");
    HttpClient operators{own};
    CHECK(operators.get("/-/healthy").status == 200);
    const Answer ready = operators.get("/-/ready");
    CHECK(ready.status == 503);
    CHECK(ready.body == "joining: this server has no store yet\n");
    CHECK_THAT(operators.get("/metrics").body, Catch::Contains("talus_cluster_joining 1"));
    CHECK(operators.get("/store/checkpoint").status == 503);
    again = std::make_unique<ServerProcess>(
        servers.settings("a"), std::vector<std::string>{"--admin", "127.0.0.1:" + std::to_string(port)});
  };
  ServerProcess b{servers.joiner("b", {port}), {"--admin", "127.0.0.1:" + std::to_string(own)}, look};
  await("readiness", [&] { return JoiningServers::is_ready(b); });
  CHECK_THAT(HttpClient{b.admin_port()}.get("/metrics").body, Catch::Contains("talus_cluster_joins_total 1"));
  servers.await_same("a", "b");
}
