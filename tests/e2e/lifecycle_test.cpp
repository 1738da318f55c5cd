// How talusd starts, refuses to start, and ends.
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include <talus/terrain/world.h>
#include <talus/voxel/content_hash.h>

#include "messages.h"
#include "raw_client.h"
#include "scratch_directory.h"
#include "served_world.h"
#include "server_process.h"
#include "world_of_a_map.h"

using namespace talus;
using namespace talus::e2e;

namespace {

namespace fs = std::filesystem;

/// Exit status 1 (2 for wrong use) and one line on stderr; returns the line.
std::string one_line(const ProgramResult& ended, int status = 1) {
  CHECK(ended.status == status);
  CHECK(std::count(ended.err.begin(), ended.err.end(), '\n') == 1);
  return ended.err;
}

/// Whether the process has told the kernel that it ignores or handles the signal.
bool ignores(pid_t process, int signal) {
  std::ifstream status{"/proc/" + std::to_string(process) + "/status"};
  std::uint64_t masked = 0;
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("SigIgn:") || line.starts_with("SigCgt:"))
      masked |= std::stoull(line.substr(7), nullptr, 16);
  }
  return (masked >> (signal - 1) & 1U) != 0;
}

ContentHash store_id(const ServerProcess& server) {
  RawClient client{server.port()};
  REQUIRE(client.send(hello()));
  return hash_of(*client.expect().as<wire::Welcome>().store_id());
}

std::string default_world_with_seed(int seed) {
  std::ifstream in{TALUS_SOURCE_DIR "/core/worlds/default.toml"};
  std::string text{std::istreambuf_iterator<char>{in}, {}};
  const std::size_t at = text.find("seed = ");
  REQUIRE(at != std::string::npos);
  return text.replace(at, text.find('\n', at) - at, "seed = " + std::to_string(seed));
}

}  // namespace

TEST_CASE("SIGTERM and SIGINT: GoAway, pending answers, exit 0") {
  const int signal = GENERATE(SIGTERM, SIGINT);
  ServerProcess server{{kClassicWorld}};
  RawClient client = greeted(server.port(), 1);
  RawClient idle{server.port()};
  // The window of one byte holds the second chunk back until there is credit, so it is pending for sure.
  REQUIRE(client.send(get_chunks({chunk_request(1, at(0, 0, 0)), chunk_request(2, at(0, 0, 0))})));
  const std::size_t bytes = client.expect_kind<wire::Chunk>().bytes();
  server.signal(signal);
  (void)client.expect_kind<wire::GoAway>();
  REQUIRE(client.send(credit(bytes)));
  (void)client.expect_kind<wire::Chunk>();
  CHECK(client.closed());
  const ReceivedFrame refused = idle.expect();  // GoAway never comes before Welcome
  CHECK(refused.as<wire::Error>().code() == wire::ErrorCode::overloaded);
  CHECK(refused.as<wire::Error>().retry_after_ms() > 0);
  CHECK(idle.closed());
  client.close();
  idle.close();
  CHECK(server.wait().status == 0);
}

TEST_CASE("a client that takes nothing cannot keep the server from ending") {
  ServerProcess server{{{"TALUS_SHUTDOWN_DRAIN_MS", "100"}}};
  RawClient client = greeted(server.port(), 1);
  REQUIRE(client.send(get_chunks({chunk_request(1, at(0, 0, 0)), chunk_request(2, at(0, 0, 0))})));
  (void)client.expect_kind<wire::Chunk>();
  server.signal(SIGTERM);
  CHECK(server.wait().status == 0);
}

TEST_CASE("a second signal ends the server at once") {
  ServerProcess server{{{"TALUS_SHUTDOWN_DRAIN_MS", "3600000"}, kClassicWorld}};
  RawClient client = greeted(server.port(), 1);
  REQUIRE(client.send(get_chunks({chunk_request(1, at(0, 0, 0)), chunk_request(2, at(0, 0, 0))})));
  (void)client.expect_kind<wire::Chunk>();
  server.signal(SIGTERM);
  (void)client.expect_kind<wire::GoAway>();
  server.signal(SIGTERM);
  CHECK(server.wait().status == 0);
}

TEST_CASE("with a lead the server goes on for it, and sends players elsewhere one after the other") {
  ServerProcess server{
      {{"TALUS_SHUTDOWN_LEAD_MS", "100"}, {"TALUS_SHUTDOWN_DRAIN_MS", "2000"}, kClassicWorld}};
  std::vector<RawClient> clients;
  for (int i = 0; i < 10; ++i) clients.push_back(greeted(server.port()));
  server.signal(SIGTERM);
  server.await_line("new ones for 100 ms");
  clients.push_back(greeted(server.port()));
  std::vector<std::chrono::steady_clock::time_point> told;
  for (RawClient& client : clients) {
    const ReceivedFrame away = client.expect_kind<wire::GoAway>();
    CHECK(away.as<wire::GoAway>().retry_after_ms() == 0);
    told.push_back(std::chrono::steady_clock::now());
    CHECK(client.closed());
  }
  CHECK(std::is_sorted(told.begin(), told.end()));
  CHECK(told.back() - told.front() > std::chrono::milliseconds{500});
  CHECK(server.wait().status == 0);
}

TEST_CASE("a second signal ends the server at once in its lead, too") {
  ServerProcess server{{{"TALUS_SHUTDOWN_LEAD_MS", "3600000"}, kClassicWorld}};
  server.signal(SIGTERM);
  server.await_line("not ready any more");
  const RawClient client = greeted(server.port());
  server.signal(SIGTERM);
  CHECK(server.wait().status == 0);
}

TEST_CASE("SIGHUP before the server is up does not end it") {
  const ServerProcess server{{}, {}, [&](const ServerProcess& starting) {
                               // From main's first lines on talusd ignores it, long before it listens.
                               const auto deadline =
                                   std::chrono::steady_clock::now() + std::chrono::seconds{60};
                               while (!ignores(starting.pid(), SIGHUP)) {
                                 REQUIRE(std::chrono::steady_clock::now() < deadline);
                               }
                               starting.signal(SIGHUP);
                             }};
  RawClient client = greeted(server.port(), 1);
  REQUIRE(client.send(get_chunks({chunk_request(1, at(0, 0, 0))})));
  (void)client.expect_kind<wire::Chunk>();
}

TEST_CASE("requests after GoAway are refused by their ids") {
  ServerProcess server{{kClassicWorld}};
  RawClient client = greeted(server.port(), 1);
  REQUIRE(client.send(get_chunks({chunk_request(1, at(0, 0, 0)), chunk_request(2, at(0, 0, 0))})));
  (void)client.expect_kind<wire::Chunk>();
  server.signal(SIGTERM);
  (void)client.expect_kind<wire::GoAway>();
  REQUIRE(client.send(get_chunks({chunk_request(3, at(0, 0, 0))})));
  const ReceivedFrame received = client.expect();
  CHECK(received.as<wire::Error>().request_id() == 3);
  CHECK(received.as<wire::Error>().retry_after_ms() > 0);
}

TEST_CASE("a taken port is one line") {
  const ServerProcess server;
  const std::string address = "127.0.0.1:" + std::to_string(server.port());
  CHECK_THAT(one_line(run_talusd({"--listen", address})), Catch::Contains(address));
}

TEST_CASE("a missing world is one line") {
  CHECK_THAT(one_line(run_talusd({"--world", "/nowhere/world.toml"})),
             Catch::Contains("/nowhere/world.toml"));
}

TEST_CASE("a wrong world is one line with its place") {
  const ScratchDirectory scratch;
  const std::string world = scratch.write("world.toml", "seed = \"many\"\n");
  CHECK_THAT(one_line(run_talusd({"--world", world})), Catch::Contains(world + ":1"));
}

TEST_CASE("a data directory that cannot be written is one line") {
  CHECK_THAT(one_line(run_talusd({"--data", "/proc/talus"})), Catch::Contains("/proc/talus"));
}

TEST_CASE("a store keeps its id over a restart") {
  const ScratchDirectory scratch;
  const std::vector<std::string> flags{"--data", (scratch / "data").string()};
  ContentHash first;
  {
    ServerProcess server{{}, flags};
    first = store_id(server);
    server.signal(SIGTERM);
    CHECK(server.wait().status == 0);
  }
  CHECK(first != ContentHash{});
  CHECK(store_id(ServerProcess{{}, flags}) == first);
}

TEST_CASE("a store of another world is refused with both fingerprints") {
  const ScratchDirectory scratch;
  const std::string data = (scratch / "data").string();
  {
    ServerProcess server{{}, {"--data", data}};
    server.signal(SIGTERM);
    CHECK(server.wait().status == 0);
  }
  const std::string world = scratch.write("other.toml", default_world_with_seed(1));
  const std::string line =
      one_line(run_talusd({"--data", data, "--world", world, "--listen", "127.0.0.1:0"}));
  CHECK_THAT(line, Catch::Contains(to_string(served_world().fingerprint())));
}

TEST_CASE("two servers do not share a data directory") {
  const ScratchDirectory scratch;
  const std::vector<std::string> flags{"--data", (scratch / "data").string(), "--listen", "127.0.0.1:0"};
  const ServerProcess server{{}, {"--data", (scratch / "data").string()}};
  CHECK_THAT(one_line(run_talusd(flags)), Catch::Contains("another talusd"));
}

TEST_CASE("a server that may not open its files or start its threads ends with one line") {
  const ScratchDirectory scratch;
  const auto start = [&](std::vector<std::string> limits) {
    const std::vector<std::string> flags{TALUSD_PATH,  "--data",      (scratch / "data").string(),
                                         "--listen",   "127.0.0.1:0", "--admin",
                                         "127.0.0.1:0"};
    limits.insert(limits.end(), flags.begin(), flags.end());
    return run_program("/usr/bin/prlimit", limits, {{"TALUS_THREADS_IO", "8"}});
  };
  CHECK_THAT(one_line(start({"--nofile=20"})),
             Catch::Contains("20 open files") && Catch::Contains("ulimit -n"));
  if (kSanitized) return;  // sanitizers map more address space than the limit
  // Each thread takes a GB of address space, so that only so many start.
  constexpr std::uint64_t kStack = 1'000'000'000;
  constexpr std::uint64_t kProgram = 400'000'000;
  for (std::uint64_t threads = 0; threads < 15; ++threads) {
    CAPTURE(threads);
    CHECK_THAT(one_line(start({"--stack=" + std::to_string(kStack) + ":" + std::to_string(kStack),
                               "--as=" + std::to_string(kProgram + threads * kStack)})),
               Catch::Contains("a thread cannot start"));
  }
}

TEST_CASE("the flag --check-config says ok, or what is wrong and where") {
  const ScratchDirectory scratch;
  const std::string right = scratch.write("right.toml", "[limits]\nconnections = 5\n");
  const std::string wrong = scratch.write("wrong.toml", "[limits]\nconections = 5\n");
  const ProgramResult ended = run_talusd({"--check-config", "--config", right});
  CHECK(ended.status == 0);
  CHECK(ended.out == "ok\n");
  CHECK_THAT(one_line(run_talusd({"--check-config", "--config", wrong})),
             Catch::Contains(wrong + ":2: limits.conections") && Catch::Contains("limits.connections?"));
}

TEST_CASE("the flag --check-config says what a published world gives away, or why it is not published") {
  const ScratchDirectory scratch;
  const ProgramResult open = run_talusd({"--check-config", "--publish", "public"});
  CHECK(open.status == 0);
  CHECK_THAT(open.err, Catch::Contains("every ore and cave"));
  CHECK(run_talusd({"--check-config"}).err.find("publish") == std::string::npos);
  const std::string large = write_world_of_a_map(scratch, 725);
  const ProgramResult withheld = run_talusd({"--check-config", "--publish", "public", "--world", large});
  CHECK(withheld.status == 0);
  CHECK_THAT(withheld.err, Catch::Contains("warning: publish: the world is not published") &&
                               Catch::Contains("\"heights.npy\"") && Catch::Contains("publish_files = true"));
  CHECK_THAT(one_line(run_talusd({"--check-config", "--publish", "all"}), 2),
             Catch::Contains("--publish: \"all\" is wrong; give one of \"none\", \"public\""));
}

TEST_CASE("why a server does not start is said in the log's format, and obeyed by no terminal") {
  const ScratchDirectory scratch;
  const std::string in_json = scratch.write("json.toml", "[log]\nformat = \"json\"\n");
  const std::string nowhere = "/nowhere/\x1b[31m.toml";
  CHECK_THAT(one_line(run_talusd({"--world", nowhere})),
             Catch::StartsWith("talusd: world: /nowhere/\\x1b[31m.toml: "));
  CHECK_THAT(one_line(run_talusd({"--config", nowhere})),
             Catch::StartsWith("talusd: /nowhere/\\x1b[31m.toml: "));
  for (const ProgramResult& ended : {run_talusd({"--config", in_json, "--world", nowhere}),
                                     run_talusd({"--config", nowhere}, {{"TALUS_LOG_FORMAT", "json"}})}) {
    CHECK_THAT(one_line(ended), Catch::StartsWith("{\"time\":") && Catch::Contains("\"level\":\"error\"") &&
                                    Catch::Contains("/nowhere/\\\\x1b[31m.toml: ") && Catch::EndsWith("}\n"));
  }
}

TEST_CASE("wrong flags are wrong use") {
  CHECK_THAT(one_line(run_talusd({"--lisen", "127.0.0.1:0"}), 2), Catch::Contains("--lisen"));
  CHECK_THAT(one_line(run_talusd({"--http", "nowhere"}), 2), Catch::Contains("--http"));
}
