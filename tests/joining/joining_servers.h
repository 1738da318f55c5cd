// Servers of one cluster, with NATS on one host, for tests of joining.
#pragma once

#include <sys/stat.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "http_client.h"
#include "nats_server.h"
#include "opened_stream.h"
#include "player.h"
#include "scratch_directory.h"
#include "server_process.h"

namespace talus::e2e {

namespace fs = std::filesystem;
using nlohmann::json;
using namespace std::chrono_literals;

/// Polls what other processes do.
template <typename Condition>
void await(const std::string& what, const Condition& condition, std::chrono::seconds patience = 60s) {
  const auto give_up = std::chrono::steady_clock::now() + patience;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > give_up) FAIL("did not come: " << what);
    std::this_thread::sleep_for(20ms);
  }
}

class JoiningServers {
 public:
  JoiningServers() {
    nats_test::NatsSettings settings;
    settings.servers = 1;
    nats = std::make_unique<nats_test::NatsServers>(settings);
    scratch.write("key", "0123456789abcdef0123456789abcdef");
    token("admin", "read,edit,admin");
    token("player", "read,edit");
  }

  /// A file with a token of these rights.
  std::string token(const std::string& name, const std::string& rights) const {
    const ProgramResult made = run_talusd(
        {"token", "--key-file", scratch / "key", "--subject", name, "--rights", rights, "--valid", "1h"});
    REQUIRE(made.status == 0);
    const std::string file = scratch.write(name, made.out);
    ::chmod(file.c_str(), 0600);
    return file;
  }

  /// Of a server that keeps its store in `data`; alone, unless `in_cluster`.
  [[nodiscard]] Settings settings(const std::string& data, bool in_cluster = true) const {
    Settings all{kClassicWorld,
                 {"TALUS_DATA", scratch / data},
                 {"TALUS_ACCESS_SIGNING_KEY_FILE", scratch / "key"},
                 {"TALUS_ACCESS_WITHOUT_TOKEN", "read,edit"},
                 {"TALUS_SHUTDOWN_DRAIN_MS", "1000"},
                 {"TALUS_RATES_SESSION_VOXELS", "100000000"},
                 {"TALUS_RATES_ADDRESS_VOXELS", "100000000"}};
    if (!in_cluster) return all;
    all["TALUS_CLUSTER_NATS"] = nats->url_list();
    all["TALUS_CLUSTER_REPLICAS"] = "1";
    all["TALUS_CLUSTER_STORE"] = store_id;
    return all;
  }
  /// Of one that may take the stores of others.
  [[nodiscard]] Settings joiner(const std::string& data, const std::vector<std::uint16_t>& peers,
                                const std::string& token_file = "admin") const {
    Settings all = settings(data);
    std::string urls;
    for (const std::uint16_t port : peers)
      urls += (urls.empty() ? "" : ",") + ("http://127.0.0.1:" + std::to_string(port));
    all["TALUS_CLUSTER_PEERS"] = urls;
    all["TALUS_CLUSTER_PEERS_TOKEN_FILE"] = scratch / token_file;
    return all;
  }
  [[nodiscard]] std::unique_ptr<ServerProcess> start(const Settings& settings) const {
    return std::make_unique<ServerProcess>(settings, std::vector<std::string>{"--admin", "127.0.0.1:0"});
  }

  /// "talusd store COMMAND ..." of `data`.
  [[nodiscard]] ProgramResult store(const std::string& data, std::vector<std::string> flags) const {
    flags.insert(flags.begin(), "store");
    return run_talusd(flags, settings(data));
  }
  [[nodiscard]] json stat(const std::string& data) const {
    const ProgramResult ended = store(data, {"stat", "--json"});
    INFO(ended.err);
    REQUIRE(ended.status == 0);
    return json::parse(ended.out);
  }

  /// A store of one machine with some edits begins the cluster.
  void begin(const std::string& data, int edits = 20) {
    {
      const auto alone = start(settings(data, false));
      build(alone->port(), edits);
    }
    store_id.clear();
    const ProgramResult joined = store(data, {"join-cluster"});
    INFO(joined.err);
    REQUIRE(joined.status == 0);
    store_id = stat(data)["store_id"];
  }

  /// Edits by one player, each where none was.
  void build(std::uint16_t port, int edits) {
    Player player;
    const auto world = player.connect(port);
    REQUIRE(world.has_value());
    for (int i = 0; i < edits; ++i) {
      const auto put = player.put(next_place(world->spawn), solid(*world));
      INFO((put ? "" : put.error().message));
      REQUIRE(put.has_value());
    }
  }
  [[nodiscard]] VoxelPos next_place(VoxelPos spawn) {
    const std::int64_t place = places++;
    return {spawn.x + place % 100, spawn.y + 80, spawn.z + place / 100};
  }
  static MaterialId solid(const client::WorldInfo& world) {
    for (const client::Material& material : world.materials) {
      if (material.phase == client::Phase::solid) return material.id;
    }
    FAIL("no solid material");
    return kAir;
  }

  /// Sets one of the stream's settings, as a person may.
  void change_stream(const std::string& name, const json& value) const {
    const std::string stream = "TALUS_" + store_id;
    json settings = json::parse(nats_test::ask(*nats, "$JS.API.STREAM.INFO." + stream))["config"];
    settings[name] = value;
    const json said = json::parse(nats_test::ask(*nats, "$JS.API.STREAM.UPDATE." + stream, settings.dump()));
    INFO(said.dump());
    REQUIRE_FALSE(said.contains("error"));
  }
  /// The stream forgets all but its last `left` messages.
  void forget(int left = 1) const {
    change_stream("max_msgs", left);
    change_stream("max_msgs", -1);
  }
  void lose_stream() const {
    const json said = json::parse(nats_test::ask(*nats, "$JS.API.STREAM.DELETE.TALUS_" + store_id));
    REQUIRE_FALSE(said.contains("error"));
  }

  static bool is_ready(ServerProcess& server) {
    return HttpClient{server.admin_port()}.get("/-/ready").status == 200;
  }
  /// Waits until both have the same, and returns it.
  json await_same(const std::string& one, const std::string& other) const {
    json a;
    json b;
    await("equal stores", [&] {
      a = stat(one);
      b = stat(other);
      return a["position"] == b["position"];
    });
    CHECK(a["hash"] == b["hash"]);
    CHECK(a["revision"] == b["revision"]);
    CHECK(a["store_id"] == b["store_id"]);
    return b;
  }

  ScratchDirectory scratch;
  std::unique_ptr<nats_test::NatsServers> nats;
  std::string store_id;
  std::atomic<std::int64_t> places{0};
};

/// A player who builds, on a thread of its own, until it goes.
class Builder {
 public:
  Builder(JoiningServers& servers, std::uint16_t port)
      : thread_{[this, &servers, port] {
          Player player;
          const auto world = player.connect(port);
          if (!world) return;
          while (!stop_) {
            if (player.put(servers.next_place(world->spawn), JoiningServers::solid(*world))) ++done_;
          }
        }} {}
  ~Builder() { stop(); }
  void stop() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
  }
  [[nodiscard]] int done() const { return done_; }

 private:
  std::atomic<bool> stop_{false};
  std::atomic<int> done_{0};
  std::thread thread_;
};

}  // namespace talus::e2e
