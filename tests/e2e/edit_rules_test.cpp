// Who may edit where, with tokens as an operator makes them: boxes, a spawn that is protected, a game server
// that edits for its players.
#include <csignal>

#include <catch2/catch.hpp>

#include "player.h"
#include "scratch_directory.h"
#include "server_process.h"

using namespace talus;
using namespace talus::e2e;

namespace {

struct World {
  ScratchDirectory scratch;
  std::string key = scratch.write("key", "0123456789abcdef0123456789abcdef");
  Settings settings{kClassicWorld,
                    {"TALUS_DATA", (scratch / "data").string()},
                    {"TALUS_ACCESS_SIGNING_KEY_FILE", key},
                    {"TALUS_ACCESS_WITHOUT_TOKEN", "read"}};

  /// What a client with such a token says of itself.
  [[nodiscard]] client::Options with_token(const std::string& rights,
                                           const std::vector<std::string>& more = {}) const {
    std::vector<std::string> flags{"token",    "--key-file", key,       "--subject", "alice",
                                   "--rights", rights,       "--valid", "1h"};
    flags.insert(flags.end(), more.begin(), more.end());
    const ProgramResult ended = run_talusd(flags);
    REQUIRE(ended.status == 0);
    client::Options options;
    options.token = ended.out.substr(0, ended.out.size() - 1);
    return options;
  }
};

std::string forbidden(const client::Result<client::EditDone>& result) {
  REQUIRE_FALSE(result.has_value());
  CHECK(result.error().kind == client::ErrorKind::refused);
  return result.error().message;
}

const MaterialId kStone{1};

}  // namespace

TEST_CASE("a token's boxes and the server's protect what they name, and admin passes the server's") {
  World world;
  world.settings["TALUS_EDITS_PROTECTED"] = "200,200:231,231";
  world.settings["TALUS_EDITS_PROTECT_SPAWN"] = "8";
  const ServerProcess server{world.settings};
  Player player{
      world.with_token("read,edit", {"--edit-in", "0,0:1000,1000", "--edit-not-in", "90,90:99,99"})};
  const auto info = player.connect(server.port());
  REQUIRE(info.has_value());
  const std::int64_t y = info->spawn.y + 50;
  CHECK(player.put({120, y, 120}, kStone).has_value());
  CHECK_THAT(forbidden(player.put({1001, y, 120}, kStone)), Catch::Contains("0,0:1000,1000"));
  CHECK_THAT(forbidden(player.put({95, y, 95}, kStone)), Catch::Contains("90,90:99,99"));
  CHECK_THAT(forbidden(player.put({200, y, 231}, kStone)), Catch::Contains("200,200:231,231"));
  Player admin{world.with_token("read,edit,admin")};
  REQUIRE(admin.connect(server.port()).has_value());
  CHECK(admin.put({200, y, 231}, kStone).has_value());
  CHECK(admin.put(info->spawn, kStone).has_value());
  Player anywhere{world.with_token("read,edit")};
  REQUIRE(anywhere.connect(server.port()).has_value());
  CHECK_THAT(forbidden(anywhere.put({info->spawn.x + 8, y, info->spawn.z}, kStone)),
             Catch::Contains("protects"));
  CHECK(anywhere.put({info->spawn.x + 9, y, info->spawn.z}, kStone).has_value());
  Player stranger;
  REQUIRE(stranger.connect(server.port()).has_value());
  CHECK_THAT(forbidden(stranger.put({120, y, 120}, kStone)), Catch::Contains("no right to edit"));
}

TEST_CASE("if a gateway is required only it edits, once for each sequence, and its players see the edits") {
  World world;
  world.settings["TALUS_EDITS_GATEWAY"] = "required";
  const ServerProcess server{world.settings};
  Player player{world.with_token("read,edit")};
  const auto info = player.connect(server.port());
  REQUIRE(info.has_value());
  const VoxelPos at{info->spawn.x, info->spawn.y + 50, info->spawn.z};
  player.move_view(at);
  CHECK_THAT(forbidden(player.put(at, kStone)), Catch::Contains("edits.gateway"));
  Player gateway{world.with_token("read,edit,gateway")};
  REQUIRE(gateway.connect(server.port()).has_value());
  client::Edit edit;
  edit.writes.push_back({at, kStone});
  edit.subject = "bob";
  CHECK(gateway.edit(edit)->changed == 1);
  player.until([&] { return player.sees(at) == kStone; });
  edit.subject = std::string(257, 'x');
  const auto long_name = gateway.edit(edit);
  REQUIRE_FALSE(long_name.has_value());
  CHECK(long_name.error().kind == client::ErrorKind::out_of_range);
}

TEST_CASE("boxes that change in the file count for new sessions after SIGHUP") {
  World world;
  const auto file = [&](const std::string& boxes) {
    return world.scratch.write("talusd.toml", "[edits]\nprotected = \"" + boxes + "\"\n");
  };
  ServerProcess server{world.settings, {"--config", file("")}};
  const client::Options options = world.with_token("read,edit");
  Player before{options};
  const auto info = before.connect(server.port());
  const VoxelPos at{info->spawn.x, info->spawn.y + 50, info->spawn.z};
  (void)file("-1000,-1000:1000,1000");
  server.signal(SIGHUP);
  CHECK_THAT(server.await_line("edits.protected"), Catch::EndsWith("for new sessions"));
  CHECK(before.put(at, kStone).has_value());
  Player after{options};
  REQUIRE(after.connect(server.port()).has_value());
  CHECK_THAT(forbidden(after.put(at, kAir)), Catch::Contains("-1000,-1000:1000,1000"));
  (void)file("-1000,-1000");
  server.signal(SIGHUP);
  CHECK_THAT(server.await_line("edits.protected"),
             Catch::Contains("error") && Catch::Contains("is not a box of the world"));
}
