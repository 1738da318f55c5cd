// What talusd may do once it serves.
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <sstream>

#include "messages.h"
#include "raw_client.h"
#include "scratch_directory.h"
#include "server_process.h"

using namespace talus;
using namespace talus::e2e;

namespace {

bool root_is_needed() {
  if (::geteuid() == 0) return false;
  WARN("only root can give up what root may do: not tested");
  return true;
}

/// What every thread says of `field`, as words.
void check_threads(const ServerProcess& server, const std::string& field, const std::string& expected) {
  const auto lines = server.of_threads(field);
  CHECK(lines.size() > 2);  // generators and sockets
  for (const std::string& line : lines) {
    std::istringstream words{line};
    std::string found;
    for (std::string word; words >> word;) found += found.empty() ? word : " " + word;
    CAPTURE(field);
    CHECK(found == expected);
  }
}

uid_t owner_of(const std::filesystem::path& path) {
  struct stat about {};
  REQUIRE(::stat(path.c_str(), &about) == 0);
  return about.st_uid;
}

}  // namespace

TEST_CASE("a program that talusd runs gains nothing") {
  const ServerProcess server;
  (void)greeted(server.port());
  check_threads(server, "NoNewPrivs:", "1");
}

TEST_CASE("root's talusd becomes the configured user, in all threads, and serves") {
  if (root_is_needed()) return;
  const ScratchDirectory scratch;
  REQUIRE(::chmod(scratch.path().c_str(), 0755) == 0);
  const std::string secret = scratch.write("secret", "0123456789abcdef");
  REQUIRE(::chmod(secret.c_str(), 0600) == 0);
  const std::string data = (scratch / "data").string();
  ServerProcess server{{{"TALUS_USER", "4780:4781"}, {"TALUS_ACCESS_SECRET_FILE", secret}}, {"--data", data}};
  {
    RawClient client{server.port()};
    REQUIRE(client.send(hello({.token = "0123456789abcdef"})));
    const ReceivedFrame received = client.expect();
    CHECK(received.as<wire::Welcome>().store_id()->low() != 0);
    REQUIRE(client.send(get_chunks({chunk_request(1, at(0, 0, 0))})));
    (void)client.expect_kind<wire::Chunk>();
  }
  check_threads(server, "Uid:", "4780 4780 4780 4780");
  check_threads(server, "Gid:", "4781 4781 4781 4781");
  check_threads(server, "Groups:", "");
  check_threads(server, "CapPrm:", "0000000000000000");
  CHECK(owner_of(data) == 4780);
  CHECK(owner_of(scratch / "data/store.toml") == 4780);
  server.signal(SIGTERM);
  const std::string log = server.wait().out;
  CHECK_THAT(log, Catch::Contains(secret + ": the user that talusd runs as cannot read it"));
  CHECK_THAT(log, !Catch::Contains("runs as root"));
}

TEST_CASE("a data directory that its user may not use is one line") {
  if (root_is_needed()) return;
  const ScratchDirectory scratch;
  const ProgramResult ended = run_talusd({"--listen", "127.0.0.1:0", "--data", scratch.path().string()},
                                         {{"TALUS_USER", "4780:4781"}});
  CHECK(ended.status == 1);
  CHECK(std::count(ended.err.begin(), ended.err.end(), '\n') == 1);
  CHECK_THAT(ended.err, Catch::Contains("Permission denied") && Catch::Contains("runs as user 4780:4781"));
}

TEST_CASE("root is warned, and root is not a user to switch to") {
  if (root_is_needed()) return;
  ServerProcess server;
  server.signal(SIGTERM);
  CHECK_THAT(server.wait().out, Catch::Contains("talusd runs as root"));
  const ProgramResult ended = run_talusd({"--check-config"}, {{"TALUS_USER", "root"}});
  CHECK(ended.status == 1);
  CHECK_THAT(ended.err, Catch::StartsWith("talusd: TALUS_USER: user: \"root\" is root"));
}
