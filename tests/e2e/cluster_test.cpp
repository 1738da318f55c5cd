// One world on several servers, over real nats-server processes: what is built at one is seen at all, and
// each edit happens once, whichever server dies, and whichever host of the log.
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <numeric>
#include <random>
#include <string_view>
#include <vector>

#include <catch2/catch.hpp>

#include "http_client.h"
#include "messages.h"
#include "nats_server.h"
#include "player.h"
#include "raw_client.h"
#include "scratch_directory.h"
#include "seed_of_run.h"
#include "server_process.h"
#include "worked_for.h"

using namespace talus;
using namespace talus::e2e;
using namespace std::chrono_literals;

namespace {

client::Options patient() {
  client::Options options;
  options.reconnect.first_delay = 20ms;
  options.reconnect.max_delay = 200ms;
  options.reconnect.max_attempts = 10'000;
  return options;
}

MaterialId solid(const client::WorldInfo& world) {
  for (const client::Material& material : world.materials) {
    if (material.phase == client::Phase::solid) return material.id;
  }
  FAIL("no solid material");
  return kAir;
}

/// Three hosts of the log, with its stream, and as many talusd as are wanted, all by themselves or as a user
/// of talusd_permissions().
class World {
 public:
  enum class As : std::uint8_t { nobody, user };
  explicit World(std::size_t servers, As as = As::nobody, Settings more = {})
      : more_{std::move(more)},
        nats_{{.more = as == As::user ? nats_test::talusd_permissions() : std::string{}}} {
    // A store of one machine, which becomes that of the cluster.
    Settings alone = settings(0);
    alone.erase("TALUS_CLUSTER_NATS");
    alone.erase("TALUS_CLUSTER_STORE");
    {
      const ServerProcess first{alone};
      Player player;
      store_ = to_string(player.connect(first.port())->store_id);
    }
    const ProgramResult made = run_talusd({"store", "join-cluster"}, settings(0));
    INFO(made.err);
    REQUIRE(made.status == 0);
    if (as == As::user) password_ = scratch_.write("password", "p");
    for (std::size_t i = 0; i < servers; ++i) servers_.push_back(start_server(settings(i)));
    for (const auto& server : servers_) ports_.push_back(server->port());
  }

  [[nodiscard]] Settings settings(std::size_t directory) const {
    Settings settings{kClassicWorld,
                      {"TALUS_DATA", (scratch_ / ("data" + std::to_string(directory))).string()},
                      {"TALUS_ACCESS_WITHOUT_TOKEN", "read,edit"},
                      {"TALUS_CLUSTER_NATS", nats_.url_list()},
                      {"TALUS_CLUSTER_STORE", store_}};
    settings.insert(more_.begin(), more_.end());
    if (!password_.empty()) {
      settings["TALUS_CLUSTER_USER"] = "talus";
      settings["TALUS_CLUSTER_PASSWORD_FILE"] = password_;
    }
    return settings;
  }
  [[nodiscard]] std::uint16_t port(std::size_t server) const { return ports_[server]; }
  [[nodiscard]] ServerProcess& server(std::size_t server) { return *servers_[server]; }
  [[nodiscard]] nats_test::NatsServers& nats() { return nats_; }
  [[nodiscard]] const std::string& store() const { return store_; }
  [[nodiscard]] std::string stream() const { return "TALUS_" + store_; }

  void kill(std::size_t server) {
    servers_[server]->signal(SIGKILL);
    (void)servers_[server]->wait();
  }
  /// At the same address, which a client goes back to; with the store of `directory`.
  void start(std::size_t server, std::size_t directory) {
    Settings again = settings(directory);
    again["TALUS_LISTEN"] = "127.0.0.1:" + std::to_string(ports_[server]);
    servers_[server] = start_server(std::move(again));
  }

 private:
  static std::unique_ptr<ServerProcess> start_server(Settings settings) {
    return std::make_unique<ServerProcess>(std::move(settings),
                                           std::vector<std::string>{"--admin", "127.0.0.1:0"});
  }

  ScratchDirectory scratch_;
  const Settings more_;
  std::string store_;
  std::string password_;  // its file
  nats_test::NatsServers nats_;
  std::vector<std::unique_ptr<ServerProcess>> servers_;
  std::vector<std::uint16_t> ports_;
};

/// Players who each build a row of their own, one voxel after the other: each edit happens only where the one
/// before did, and only once, or its guards would not hold.
class Builders {
 public:
  Builders(World& world, int count, std::size_t servers) {
    for (int i = 0; i < count; ++i) {
      builders_.push_back(std::make_unique<Builder>());
      const auto info = builders_.back()->player.connect(world.port(static_cast<std::size_t>(i) % servers));
      REQUIRE(info.has_value());
      stone_ = solid(*info);
      origin_ = {info->spawn.x, info->max_y + 8, info->spawn.z};  // above all hills
    }
  }

  void build_until(std::int64_t more) {
    const std::int64_t wanted = done() + more;
    const auto give_up = std::chrono::steady_clock::now() + 2min;
    while (done() < wanted) {
      if (std::chrono::steady_clock::now() > give_up) FAIL("edits are not answered");
      for (std::size_t i = 0; i < builders_.size(); ++i) {
        Builder& builder = *builders_[i];
        build(builder, static_cast<int>(i));
        builder.player.io.run_one_for(1ms);
        builder.player.io.poll();
        if (builder.player.io.stopped()) builder.player.io.restart();
      }
    }
  }
  void finish() {
    for (auto& builder : builders_) builder->player.until([&] { return builder->done == builder->next; });
  }
  [[nodiscard]] std::int64_t done() const {
    std::int64_t sum = 0;
    for (const auto& builder : builders_) sum += builder->done;
    return sum;
  }
  /// The rows as a fresh player sees them at that port, and that no edit happened twice.
  void check(std::uint16_t port) {
    Player viewer{patient()};
    REQUIRE(viewer.connect(port).has_value());
    for (std::size_t i = 0; i < builders_.size(); ++i) {
      const Builder& builder = *builders_[i];
      for (std::int64_t x = 0; x <= builder.done; ++x) {
        const VoxelPos at{origin_.x + x, origin_.y, origin_.z + static_cast<std::int64_t>(i)};
        if (!viewer.sees(at)) viewer.move_view(at);
        CAPTURE(i, x);
        CHECK(viewer.sees(at) == (x < builder.done ? stone_ : kAir));
      }
    }
    // One revision an edit.
    CHECK(viewer.put({origin_.x, origin_.y + 1, origin_.z}, stone_)->revision ==
          static_cast<std::uint64_t>(done()) + 1);
  }

 private:
  struct Builder {
    Player player{patient()};
    std::int64_t next = 0;  // voxels of its row that were asked for
    std::int64_t done = 0;  // that were acknowledged
    std::uint64_t last_revision = 0;
  };

  void build(Builder& builder, int row) {
    while (builder.next - builder.done < 8) {
      const VoxelPos at{origin_.x + builder.next, origin_.y, origin_.z + row};
      client::Edit edit;
      edit.guards.push_back({at, kAir});
      if (builder.next > 0) edit.guards.push_back({{at.x - 1, at.y, at.z}, stone_});
      edit.writes.push_back({at, stone_});
      ++builder.next;
      builder.player.client.edit(std::move(edit), [&builder](const client::Result<client::EditDone>& result) {
        INFO((result ? std::string{} : result.error().message));
        REQUIRE(result.has_value());
        CHECK(result->changed == 1);
        CHECK(result->revision > builder.last_revision);
        builder.last_revision = result->revision;
        ++builder.done;
      });
    }
  }

  std::vector<std::unique_ptr<Builder>> builders_;
  VoxelPos origin_;
  MaterialId stone_{};
};

}  // namespace

TEST_CASE("a player's build at one server reaches players at another, and all servers are ready") {
  World world{3};
  Player digger;
  Player viewer;
  const auto info = digger.connect(world.port(0));
  REQUIRE(info.has_value());
  CHECK(to_string(info->store_id) == world.store());
  REQUIRE(viewer.connect(world.port(1)).has_value());
  const VoxelPos at{info->spawn.x, info->spawn.y + 40, info->spawn.z};
  viewer.move_view(at);
  REQUIRE(digger.put(at, solid(*info))->changed == 1);
  viewer.until([&] { return viewer.sees(at) == solid(*info); });
  // And the other way.
  CHECK(viewer.put(at, kAir)->revision == 2);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint16_t admin = world.server(i).admin_port();
    viewer.until([&] { return HttpClient{admin}.get("/-/ready").body == "ready\n"; });
    const std::string metrics = HttpClient{admin}.get("/metrics").body;
    CHECK(metrics.find("\ntalus_cluster_quorum 1\n") != std::string::npos);
    CHECK(metrics.find("\ntalus_cluster_state_differs 0\n") != std::string::npos);
  }
}

TEST_CASE("a server that may not read the log's messages says so at each NATS server that it tries") {
  constexpr std::string_view kName = "\"name\": \"talusd\"";
  World world{1, World::As::user};
  Player player{patient()};
  const auto info = player.connect(world.port(0));
  REQUIRE(info.has_value());
  const VoxelPos at{info->spawn.x, info->max_y + 8, info->spawn.z};
  REQUIRE(player.put(at, solid(*info)).has_value());
  const std::uint16_t admin = world.server(0).admin_port();
  const auto ready = [&] { return HttpClient{admin}.get("/-/ready"); };
  const auto says_why = [&] {
    const auto says = ready();
    return says.status == 200 && says.body.find("no edits are taken") != std::string::npos &&
           says.body.find("MSG.GET") != std::string::npos;
  };
  /// The connections of talusd that the NATS server has had, closed ones included.
  const auto connections = [&](std::size_t server) {
    const std::string page = world.nats().page(server, "/connz?state=all");
    std::size_t count = 0;
    for (auto name = page.find(kName); name != std::string::npos; name = page.find(kName, name + 1)) ++count;
    return count;
  };
  player.until([&] { return ready().body == "ready\n"; });
  std::vector<std::size_t> before;
  for (std::size_t i = 0; i < world.nats().count(); ++i) before.push_back(connections(i));
  REQUIRE(std::accumulate(before.begin(), before.end(), std::size_t{0}) > 0);
  world.nats().reconfigure(nats_test::talusd_permissions({.messages = false}));
  player.until(says_why);
  CHECK(HttpClient{admin}.get("/metrics").body.find("\ntalus_cluster_quorum 0\n") != std::string::npos);
  // It may be this NATS server alone that denies it, so the others are tried.
  for (std::size_t i = 0; i < world.nats().count(); ++i) {
    player.until([&] { return connections(i) > before[i]; });
  }
  player.until(says_why);
  world.nats().reconfigure(nats_test::talusd_permissions());
  player.until([&] { return ready().body == "ready\n"; });
  CHECK(player.put({at.x + 1, at.y, at.z}, solid(*info))->revision == 2);
}

TEST_CASE("subscriptions that NATS takes away are said, and subscribed to again once NATS lets the server") {
  World world{1, World::As::user};
  Player player{patient()};
  const auto info = player.connect(world.port(0));
  REQUIRE(info.has_value());
  const std::uint16_t admin = world.server(0).admin_port();
  const auto says = [&](std::string_view text, std::string_view metric) {
    const auto ready = HttpClient{admin}.get("/-/ready");
    return ready.status == 200 && ready.body.find(text) != std::string::npos &&
           HttpClient{admin}.get("/metrics").body.find(metric) != std::string::npos;
  };
  const auto is_well = [&] {
    return HttpClient{admin}.get("/-/ready").body == "ready\n" &&
           says("ready", "\ntalus_cluster_quorum 1\n") && says("ready", "\ntalus_cluster_tail 1\n");
  };
  player.until(is_well);
  world.nats().reconfigure(nats_test::talusd_permissions({.tail = false}));
  player.until([&] { return says(".tail'", "\ntalus_cluster_tail 0\n"); });
  const VoxelPos at{info->spawn.x, info->max_y + 8, info->spawn.z};
  CHECK(player.put(at, solid(*info))->revision == 1);
  world.nats().reconfigure(nats_test::talusd_permissions());
  player.until(is_well);
  world.nats().reconfigure(nats_test::talusd_permissions({.answers = false}));
  player.until([&] { return says("Subscription to '_INBOX", "\ntalus_cluster_quorum 0\n"); });
  world.nats().reconfigure(nats_test::talusd_permissions());
  player.until(is_well);
  CHECK(player.put(at, kAir)->revision == 2);
}

TEST_CASE("an operator's rollback at one server is undone at all servers") {
  World world{2};
  Player digger;
  Player viewer;
  const auto info = digger.connect(world.port(0));
  REQUIRE(info.has_value());
  REQUIRE(viewer.connect(world.port(1)).has_value());
  const VoxelPos at{info->spawn.x, info->max_y + 8, info->spawn.z};
  viewer.move_view(at);
  REQUIRE(digger.put(at, solid(*info)).has_value());
  viewer.until([&] { return viewer.sees(at) == solid(*info); });
  const ProgramResult rolled = run_talusd({"store", "rollback", "--subject", "", "--since", "1h", "--box",
                                           "-10000,-10000,-10000,10000,10000,10000"},
                                          world.settings(1));
  INFO(rolled.err);
  CHECK(rolled.status == 0);
  viewer.until([&] { return viewer.sees(at) == kAir; });
  digger.move_view(at);
  CHECK(digger.sees(at) == kAir);
  const ProgramResult history =
      run_talusd({"store", "history", "--at",
                  std::to_string(at.x) + "," + std::to_string(at.y) + "," + std::to_string(at.z)},
                 world.settings(0));
  CHECK(history.out.find("talusd store rollback") != std::string::npos);
}

TEST_CASE("cut off from the log a server serves chunks, refuses edits, says so, and recovers by itself") {
  World world{1};
  Player player{patient()};
  const auto info = player.connect(world.port(0));
  REQUIRE(info.has_value());
  const VoxelPos at{info->spawn.x, info->max_y + 8, info->spawn.z};
  REQUIRE(player.put(at, solid(*info)).has_value());
  const std::uint16_t admin = world.server(0).admin_port();
  player.until([&] { return HttpClient{admin}.get("/-/ready").body == "ready\n"; });
  for (std::size_t i = 0; i < world.nats().count(); ++i) world.nats().freeze(i);
  std::optional<client::Result<client::EditDone>> doubtful;
  client::Edit edit;
  edit.writes.push_back({{at.x + 1, at.y, at.z}, solid(*info)});
  player.client.edit(std::move(edit), [&](auto result) { doubtful = std::move(result); });
  player.until(
      [&] { return HttpClient{admin}.get("/-/ready").body.find("no edits are taken") != std::string::npos; });
  CHECK(HttpClient{admin}.get("/-/ready").status == 200);
#ifdef TALUS_CLIENT_PATH
  // Who gives up hears what he waited for.
  const auto gave_up = run_program(
      TALUS_CLIENT_PATH, {"--connect", "127.0.0.1:" + std::to_string(world.port(0)), "edit",
                          std::to_string(at.x) + "," + std::to_string(at.y + 9) + "," + std::to_string(at.z),
                          "--material", "air", "--timeout", "3"});
  CHECK(gave_up.status != 0);
  CHECK_THAT(gave_up.err, Catch::Contains("has not answered within 3 s; it said: ") &&
                              Catch::Contains("no edits are taken"));
#endif
  player.move_view({at.x + 400, at.y, at.z});  // land that nobody has seen
  for (std::size_t i = 0; i < world.nats().count(); ++i) world.nats().go_on(i);
  player.until([&] { return doubtful.has_value(); });
  CHECK(doubtful->has_value());
  CHECK(player.put({at.x + 2, at.y, at.z}, solid(*info))->revision == 3);
  player.until([&] { return HttpClient{admin}.get("/-/ready").body == "ready\n"; });
}

TEST_CASE("a client that is silent while the log is away goes in its time, and its edits happen once") {
  World world{1,
              World::As::nobody,
              {{"TALUS_LIMITS_IDLE_TIMEOUT_MS", "5000"}, {"TALUS_LIMITS_QUEUED_BYTES_PER_SESSION", "65536"}}};
  const std::uint16_t admin = world.server(0).admin_port();
  const auto until_ready = [&] {
    while (HttpClient{admin}.get("/-/ready").body != "ready\n") std::this_thread::yield();
  };
  until_ready();
  const auto attached = [&](RawClient& client, const wire::Hash128* editor) {
    REQUIRE(client.send(
        protocol::make_frame([&](auto& builder) { return wire::CreateAttach(builder, editor); })));
    return client.expect_kind<wire::Attached>();
  };
  /// Says meanwhile that the client is there: NATS may elect a leader first.
  const auto result_of = [](RawClient& client) {
    while (true) {
      auto frame = client.receive_within(std::chrono::milliseconds{300});
      if (!frame) {
        REQUIRE(
            client.send(protocol::make_frame([](auto& builder) { return wire::CreatePing(builder, 1); })));
      } else if (frame->kind() != wire::Body::Pong) {
        (void)frame->as<wire::EditResult>();
        return *std::move(frame);
      }
    }
  };
  /// So large that the server reads nothing more from its client.
  const auto large_edit = [](std::uint32_t id) {
    return protocol::make_frame([&](auto& builder) {
      std::vector<wire::VoxelWrite> writes;
      for (std::int64_t x = 0; x < 1'000; ++x)
        writes.emplace_back(wire::Voxel{x, 4'000, id}, std::uint16_t{2});
      return wire::CreateEdit(builder, id, builder.CreateVectorOfStructs(writes), id);
    });
  };
  RawClient silent = greeted(world.port(0));
  const ReceivedFrame first = attached(silent, nullptr);
  const wire::Hash128 editor = *first.as<wire::Attached>().editor();
  for (std::size_t i = 0; i < world.nats().count(); ++i) world.nats().freeze(i);
  for (const std::uint32_t id : {1U, 2U, 3U}) REQUIRE(silent.send(large_edit(id)));
  await_metric(admin, "talus_memory_bytes{use=\"sessions\"}", [](double bytes) { return bytes == 0; });
  CHECK(metric(admin, "talus_sessions{state=\"greeted\"}") == 0);
  CHECK(metric(admin, "talus_edits_waiting{where=\"intake\"}") == 0);

  for (std::size_t i = 0; i < world.nats().count(); ++i) world.nats().go_on(i);
  until_ready();
  RawClient again = greeted(world.port(0));
  const ReceivedFrame second = attached(again, &editor);
  CHECK(second.as<wire::Attached>().known());
  const std::uint64_t decided = second.as<wire::Attached>().last_sequence();
  for (const std::uint32_t id : {1U, 2U, 3U}) {
    REQUIRE(again.send(large_edit(id)));
    const ReceivedFrame answer = result_of(again);
    CHECK(answer.as<wire::EditResult>().changed() == 1'000);
    CHECK(answer.as<wire::EditResult>().revision() == id);
  }
  CHECK(decided <= 3);
}

TEST_CASE("players whose server is killed get their answers from another, each edit once") {
  const char* const given = std::getenv("TALUS_KILLS");
  const int kills = given != nullptr ? std::atoi(given) : (kSanitized ? 1 : 3);
  const std::uint64_t seed = seed_of_run();
  CAPTURE(seed);
  std::mt19937_64 random{seed};
  World world{2};
  Builders builders{world, 4, 2};
  std::size_t spare = 2;
  std::size_t directories[] = {0, 1};
  for (int kill = 0; kill < kills; ++kill) {
    builders.build_until(20 + static_cast<std::int64_t>(random() % 100));
    const std::size_t victim = random() % 2;
    world.kill(victim);
    // Behind its address comes a server that never saw these players.
    std::swap(spare, directories[victim]);
    world.start(victim, directories[victim]);
  }
  builders.build_until(20);
  builders.finish();
  builders.check(world.port(0));
  if (given != nullptr)
    std::cout << kills << " kills, " << builders.done() << " edits, seed " << seed << '\n';
}

TEST_CASE("the log's leader is killed under players: no edit is lost or done twice, and they go on") {
  const char* const given = std::getenv("TALUS_KILLS");
  const int kills = given != nullptr ? std::atoi(given) : 1;
  World world{2};
  Builders builders{world, 4, 2};
  for (int kill = 0; kill < kills; ++kill) {
    builders.build_until(100);
    const std::size_t leader = world.nats().leader_of(world.stream());
    world.nats().kill(leader);
    builders.build_until(100);
    world.nats().start(leader);
    world.nats().await_replicas(world.stream());
  }
  builders.finish();
  builders.check(world.port(1));
}
