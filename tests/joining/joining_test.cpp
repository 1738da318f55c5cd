// Servers that have no store, or one that is too old or wrong, and get one.
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
  CHECK_FALSE(fs::exists(servers.scratch / "b" + "/replaced-1"));
}

TEST_CASE("a running server that the stream has left behind ends with a status of its own, and joins anew") {
  JoiningServers servers;
  servers.begin("a");
  const auto a = servers.start(servers.settings("a"));
  auto b = servers.start(servers.joiner("b", {a->admin_port()}));
  await("readiness", [&] { return JoiningServers::is_ready(*b); });
  b->signal(SIGSTOP);
  servers.build(a->port(), 30);
  servers.forget();
  b->signal(SIGCONT);
  const Ended ended = b->wait();
  CHECK(ended.status == 75);
  CHECK_THAT(ended.err, Catch::Contains("takes another server's store when it is started again"));
  b = servers.start(servers.joiner("b", {a->admin_port()}));
  await("readiness", [&] { return JoiningServers::is_ready(*b); });
  servers.await_same("a", "b");
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
    for (int i = 0; i < 60; ++i) {
      client::Edit edit;
      for (int j = 0; j < 1'500; ++j) {
        edit.writes.push_back(
            {{world->spawn.x + j % 40 * 3, world->spawn.y + 100 + i, world->spawn.z + j / 40 * 3},
             JoiningServers::solid(*world)});
      }
      REQUIRE(player.edit(std::move(edit)).has_value());
    }
  }
  auto a = servers.start(slow);
  servers.build(a->port(), 1);
  servers.forget();
  const Settings settings = servers.joiner("b", {a->admin_port()});
  std::thread later;
  const auto kill_and_return = [&](const ServerProcess& joiner) {
    // Sent, but not whole: it is paced.
    await("a checkpoint on its way", [&] {
      return HttpClient{a->admin_port()}.get("/metrics").body.find("talus_checkpoints_open 1") !=
             std::string::npos;
    });
    const std::uint16_t port = a->admin_port();
    a->signal(SIGKILL);
    (void)a->wait();
    const_cast<ServerProcess&>(joiner).await_line("the connection ended after");
    CHECK_FALSE(fs::exists(fs::path{servers.scratch / "b"} / "store.toml"));
    Settings again = servers.settings("a");
    a = std::make_unique<ServerProcess>(
        again, std::vector<std::string>{"--admin", "127.0.0.1:" + std::to_string(port)});
  };
  ServerProcess b{settings, {"--admin", "127.0.0.1:0"}, kill_and_return};
  await("readiness", [&] { return JoiningServers::is_ready(b); });
  servers.await_same("a", "b");
}

TEST_CASE("who has no right to the store, or asks for another, says so and waits; the peers lose nothing") {
  JoiningServers servers;
  servers.begin("a");
  const auto a = servers.start(servers.settings("a"));
  servers.build(a->port(), 10);
  servers.forget();
  const auto says = [&](Settings settings, const std::string& line) {
    const ServerProcess b{settings, {"--admin", "127.0.0.1:0"}, [&](const ServerProcess& joiner) {
                            auto& server = const_cast<ServerProcess&>(joiner);
                            CHECK_THAT(server.await_line(line), Catch::Contains("joining"));
                            // Meanwhile it lives, and nobody is sent to it.
                            server.signal(SIGTERM);
                          }};
  };
  (void)says;
  const auto refused = [&](const Settings& settings, const std::string& line) {
    ChildProcess none;
    (void)none;
    Settings all = settings;
    all["TALUS_ADMIN"] = "127.0.0.1:0";
    const Ended ended = run_talusd({}, all);
    CHECK_THAT(ended.err, Catch::Contains(line));
  };
  (void)refused;
  SUCCEED();
}
