// Stores that move into a cluster, out of it, and into another.
#include "joining_servers.h"

using namespace talus;
using namespace talus::e2e;

TEST_CASE("into a cluster and back a store keeps its revisions, hash and players") {
  JoiningServers servers;
  {
    const auto alone = servers.start(servers.settings("a", false));
    servers.build(alone->port(), 20);
  }
  const json before = servers.stat("a");
  CHECK(servers.store("a", {"join-cluster"}).status == 0);
  const ProgramResult twice = servers.store("a", {"join-cluster"});
  CHECK(twice.status == 1);
  CHECK_THAT(twice.err, Catch::Contains("is in a cluster already"));
  servers.store_id = before["store_id"];
  json during = servers.stat("a");
  for (const char* const same : {"store_id", "revision", "position", "hash"})
    CHECK(during[same] == before[same]);
  {
    // Alone it would go on without the others.
    const ProgramResult refused = run_talusd({"--listen", "127.0.0.1:0"}, servers.settings("a", false));
    CHECK(refused.status == 1);
    CHECK_THAT(refused.err, Catch::Contains("talusd store leave-cluster"));
    const auto member = servers.start(servers.settings("a"));
    servers.build(member->port(), 10);
  }
  during = servers.stat("a");
  CHECK(during["revision"] == before["revision"].get<int>() + 10);
  const ProgramResult asked = servers.store("a", {"leave-cluster"});
  CHECK(asked.status == 1);
  CHECK_THAT(asked.err,
             Catch::Contains("nothing is changed yet") && Catch::Contains("it has all that the stream has"));
  CHECK(servers.stat("a") == during);
  const bool keeps_id = GENERATE(false, true);
  servers.scratch.write("a/rejoin", "its store was found to be wrong");  // which it says of the cluster's
  std::vector<std::string> flags{"leave-cluster", "--yes"};
  if (keeps_id) flags.emplace_back("--keep-id");
  const ProgramResult left = servers.store("a", flags);
  INFO(left.err);
  CHECK(left.status == 0);
  const json after = servers.stat("a");
  for (const char* const same : {"revision", "position", "hash"}) CHECK(after[same] == during[same]);
  CHECK((after["store_id"] == before["store_id"]) == keeps_id);
  CHECK_FALSE(fs::exists(servers.scratch / "a/rejoin"));
  const auto alone = servers.start(servers.settings("a", false));
  servers.build(alone->port(), 3);
  CHECK(servers.stat("a")["revision"] == during["revision"].get<int>() + 3);
}

TEST_CASE("a server that leaves a cluster reports how far it is behind") {
  JoiningServers servers;
  servers.begin("a");
  const auto a = servers.start(servers.settings("a"));
  {
    const auto b = servers.start(servers.joiner("b", {a->admin_port()}));
    await("readiness", [&] { return JoiningServers::is_ready(*b); });
  }
  servers.build(a->port(), 3);
  const ProgramResult asked = servers.store("b", {"leave-cluster"});
  CHECK(asked.status == 1);
  CHECK_THAT(asked.err, Catch::Contains("more, whose edits are not in it"));
  CHECK_THAT(servers.store("a", {"leave-cluster", "--yes"}).err, Catch::Contains("a talusd uses it"));
}

TEST_CASE("if the stream is lost a server refuses to continue, and a fork begins anew from its store") {
  JoiningServers servers;
  servers.begin("a");
  {
    const auto a = servers.start(servers.settings("a"));
    servers.build(a->port(), 10);
  }
  const json before = servers.stat("a");
  servers.lose_stream();
  SECTION("and the stream is missing") {}
  SECTION("and another has its name") {
    const std::string& id = servers.store_id;
    nats_test::make_stream(*servers.nats, {"TALUS_" + id, "talus." + id + ".log", "talus." + id + ".tail"},
                           1);
    CHECK_THAT(servers.store("a", {"join-cluster"}).err, Catch::Contains("is in a cluster already"));
  }
  const ProgramResult refused = run_talusd({"--listen", "127.0.0.1:0"}, servers.settings("a"));
  CHECK(refused.status == 1);
  CHECK_THAT(refused.err, Catch::Contains("talusd store fork"));
  const ProgramResult asked = servers.store("a", {"fork"});
  CHECK(asked.status == 1);
  CHECK_THAT(asked.err, Catch::Contains("nothing is changed yet"));
  servers.scratch.write("a/rejoin", "its store was found to be wrong");
  const ProgramResult forked = servers.store("a", {"fork", "--yes"});
  INFO(forked.err);
  REQUIRE(forked.status == 0);
  const json after = servers.stat("a");
  for (const char* const same : {"revision", "position", "hash"}) CHECK(after[same] == before[same]);
  CHECK(after["store_id"] != before["store_id"]);
  CHECK_FALSE(fs::exists(servers.scratch / "a/rejoin"));
  servers.store_id = after["store_id"];
  const auto a = servers.start(servers.settings("a"));
  servers.build(a->port(), 5);
  const auto b = servers.start(servers.joiner("b", {a->admin_port()}));
  await("readiness", [&] { return JoiningServers::is_ready(*b); });
  servers.await_same("a", "b");
}

TEST_CASE("a stream with other settings is refused by name, both at the start and when a store enters") {
  JoiningServers servers;
  servers.begin("a");
  servers.change_stream("max_msgs", 1'000'000);
  const ProgramResult refused = run_talusd({"--listen", "127.0.0.1:0"}, servers.settings("a"));
  CHECK(refused.status == 1);
  CHECK_THAT(refused.err, Catch::Contains("max_msgs is 1000000 and should be -1"));
  REQUIRE(servers.store("a", {"leave-cluster", "--yes", "--keep-id"}).status == 0);
  const ProgramResult outside = servers.store("a", {"join-cluster"});
  CHECK(outside.status == 1);
  CHECK_THAT(outside.err, Catch::Contains("max_msgs is 1000000 and should be -1"));
  servers.change_stream("max_msgs", -1);
  CHECK(servers.store("a", {"join-cluster"}).status == 0);
  // A person who changes one while servers run stops none of them.
  const auto a = servers.start(servers.settings("a"));
  await("readiness", [&] { return JoiningServers::is_ready(*a); });
  servers.change_stream("max_msgs", 1'000'000);
  servers.build(a->port(), 3);
  CHECK(JoiningServers::is_ready(*a));
}

TEST_CASE("a server that starts while NATS is away serves what it has, and takes edits once it is back") {
  JoiningServers servers;
  servers.begin("a");
  Settings settings = servers.settings("a");
  bool hangs = false;
  SECTION("with the world as it was") {}
  SECTION("of a NATS server that takes connections and says nothing") {
    hangs = true;
  }
  SECTION("with a world that names a new material, which waits for the log") {
    const std::string world = read_whole(settings["TALUS_WORLD"]);
    settings["TALUS_WORLD"] = servers.scratch.write(
        "world.toml", world + "\n[[placeable]]\nname = \"planks\"\ncolour = \"#a07848\"\n");
  }
  if (hangs) {
    servers.nats->freeze(0);
  } else {
    servers.nats->kill(0);
  }
  const auto a = servers.start(settings);
  await("readiness", [&] { return JoiningServers::is_ready(*a); });
  CHECK_THAT(HttpClient{a->admin_port()}.get("/-/ready").body, Catch::Contains("no edits are taken"));
  if (hangs) {
    servers.nats->go_on(0);
  } else {
    servers.nats->start(0);
  }
  servers.build(a->port(), 3);
  CHECK(JoiningServers::is_ready(*a));
}

TEST_CASE("a fork whose stream cannot be made leaves the store in its cluster") {
  JoiningServers servers;
  servers.begin("a");
  const json before = servers.stat("a");
  SECTION("NATS is away") {
    servers.nats->kill(0);
  }
  SECTION("NATS refuses") {
    // There are not so many hosts.
    Settings wants_more = servers.settings("a");
    wants_more["TALUS_CLUSTER_REPLICAS"] = "3";
    const ProgramResult refused = run_talusd({"store", "fork", "--yes"}, wants_more);
    CHECK(refused.status == 1);
    CHECK_THAT(refused.err,
               Catch::Contains("nothing is changed") && Catch::Contains("replicas > 1 not supported"));
    CHECK(servers.stat("a") == before);
    servers.nats->kill(0);
  }
  const ProgramResult away = servers.store("a", {"fork", "--yes"});
  CHECK(away.status == 1);
  CHECK(away.err.find('\n') == away.err.size() - 1);
  CHECK_THAT(away.err, Catch::Contains("nothing is changed"));
  CHECK(servers.stat("a") == before);
}

TEST_CASE("without NATS a store does not move, and stays as it is") {
  JoiningServers servers;
  {
    const auto alone = servers.start(servers.settings("a", false));
    servers.build(alone->port(), 3);
  }
  const json before = servers.stat("a");
  Settings none = servers.settings("a", false);
  const ProgramResult unnamed = run_talusd({"store", "join-cluster"}, none);
  CHECK(unnamed.status == 1);
  CHECK_THAT(unnamed.err, Catch::Contains("cluster.nats: no NATS server is named"));
  servers.nats->kill(0);
  const ProgramResult away = servers.store("a", {"join-cluster"});
  CHECK(away.status == 1);
  CHECK(away.err.find('\n') == away.err.size() - 1);
  CHECK(servers.stat("a") == before);
}
