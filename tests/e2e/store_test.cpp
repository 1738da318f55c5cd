// "talusd store" beside a real talusd: backups under edits, rollback that players see, and commands that are
// killed.
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "player.h"
#include "scratch_directory.h"
#include "seed_of_run.h"
#include "server_process.h"

using namespace talus;
using namespace talus::e2e;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

Settings editable(const fs::path& data) {
  return {kClassicWorld,
          {"TALUS_DATA", data.string()},
          {"TALUS_ACCESS_WITHOUT_TOKEN", "read,edit"},
          {"TALUS_RATES_SESSION_VOXELS", "100000000"},
          {"TALUS_RATES_ADDRESS_VOXELS", "100000000"}};
}

ProgramResult store(std::vector<std::string> flags) {
  flags.insert(flags.begin(), "store");
  return run_talusd(flags);
}
/// What it prints; the test fails where it does not succeed.
std::string sound(const std::vector<std::string>& flags) {
  const ProgramResult ended = store(flags);
  INFO(ended.err);
  REQUIRE(ended.status == 0);
  return ended.out;
}
std::string refused(const std::vector<std::string>& flags) {
  const ProgramResult ended = store(flags);
  INFO(ended.out);
  REQUIRE(ended.status == 1);
  CHECK(ended.err.find('\n') == ended.err.size() - 1);
  return ended.err;
}
nlohmann::json figures(const fs::path& data) {
  return nlohmann::json::parse(sound({"stat", "--json", "--data", data.string()}));
}

/// Runs a command of talusd, and kills it when `wait` returns where it has not ended. Whether it had.
bool run_and_kill(std::vector<std::string> flags, const std::function<void()>& wait) {
  flags.insert(flags.begin(), TALUSD_PATH);
  std::vector<char*> arguments;
  for (std::string& flag : flags) arguments.push_back(flag.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
  pid_t pid = -1;
  REQUIRE(::posix_spawn(&pid, TALUSD_PATH, &actions, nullptr, arguments.data(), environ) == 0);
  posix_spawn_file_actions_destroy(&actions);
  wait();
  ::kill(pid, SIGKILL);
  int status = 0;
  REQUIRE(::waitpid(pid, &status, 0) == pid);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// The same of talusd store, which is killed after so long.
bool run_and_kill(std::vector<std::string> flags, std::chrono::microseconds after) {
  flags.insert(flags.begin(), "store");
  return run_and_kill(std::move(flags),
                      [&] { std::this_thread::sleep_for(after); });  // a kill comes at any time
}

/// A plane of 64 chunks.
client::Edit plane(VoxelPos at, MaterialId material) {
  client::Edit edit;
  edit.fills.push_back({at, {at.x + 255, at.y, at.z + 255}, material, std::nullopt});
  return edit;
}

}  // namespace

TEST_CASE("a backup under edits has all that was acknowledged before it, and is restored as it was") {
  const ScratchDirectory scratch;
  const fs::path data = scratch / "data";
  VoxelPos origin;
  std::int64_t before = 0;
  nlohmann::json backed_up;
  {
    const ServerProcess server{editable(data)};
    Player player;
    const auto world = player.connect(server.port());
    REQUIRE(world.has_value());
    origin = {world->spawn.x, world->spawn.y + 100, world->spawn.z};
    std::int64_t built = 0;
    const auto build = [&] {
      REQUIRE(player.put({origin.x + built, origin.y, origin.z}, MaterialId{2}).has_value());
      ++built;
    };
    while (built < 50) build();
    before = built;
    for (const char* const name : {"backup", "second"}) {
      ProgramResult ended;
      std::atomic<bool> done = false;
      std::thread command{[&] {
        ended = store({"backup", (scratch / name).string(), "--data", data.string()});
        done = true;
      }};
      while (!done) build();
      command.join();
      INFO(ended.err);
      REQUIRE(ended.status == 0);
    }
    CHECK(built > before);
    // Others read too, and none of it is left behind.
    CHECK(sound({"verify", "--data", data.string()}).starts_with("sound: "));
    CHECK(figures(data).at("server_runs") == true);
    CHECK(sound({"export", (scratch / "edits").string(), "--data", data.string()}).find("voxels in") !=
          std::string::npos);
    CHECK(refused({"restore", (scratch / "backup").string(), "--data", data.string(), "--replace"})
              .find("a talusd uses it; stop it first") != std::string::npos);
    CHECK(refused({"backup", (scratch / "backup").string(), "--data", data.string()})
              .find("the directory is not empty") != std::string::npos);
  }
  for (const auto& entry : fs::directory_iterator{data}) {
    CHECK_FALSE(entry.path().filename().string().starts_with("talus-"));
  }
  const fs::path again = scratch / "again";
  (void)sound({"restore", (scratch / "backup").string(), "--data", again.string()});
  (void)sound({"verify", "--data", again.string()});
  const std::string manifest = read_whole(scratch / "backup" / "manifest");
  const nlohmann::json restored = figures(again);
  CHECK(manifest.find("\nhash " + restored.at("hash").get<std::string>() + "\n") != std::string::npos);
  CHECK(restored.at("store_id") != figures(data).at("store_id"));
  CHECK(restored.at("revision") >= before);
  const ServerProcess server{editable(again)};
  Player player;
  REQUIRE(player.connect(server.port()).has_value());
  player.move_view(origin);
  for (std::int64_t i = 0; i < std::min<std::int64_t>(before, 16); ++i) {
    CHECK(player.sees({origin.x + i, origin.y, origin.z}) == MaterialId{2});
  }
}

TEST_CASE("a griefer's edits are found and undone while players watch, and others' work stays") {
  const ScratchDirectory scratch;
  const fs::path data = scratch / "data";
  const ServerProcess server{editable(data)};
  Player griefer;
  Player viewer;
  const auto world = griefer.connect(server.port());
  REQUIRE(world.has_value());
  REQUIRE(viewer.connect(server.port()).has_value());
  const VoxelPos at{world->spawn.x & ~31, (world->spawn.y + 64) & ~31, world->spawn.z & ~31};
  viewer.move_view(at);
  client::Edit block;
  block.fills.push_back({at, {at.x + 7, at.y + 7, at.z + 7}, MaterialId{2}, std::nullopt});
  REQUIRE(griefer.edit(block).has_value());
  viewer.until([&] { return viewer.sees(at) == MaterialId{2}; });
  const auto text = [](VoxelPos voxel) {
    return std::to_string(voxel.x) + "," + std::to_string(voxel.y) + "," + std::to_string(voxel.z);
  };
  const std::string box = text(at) + "," + text({at.x + 3, at.y + 7, at.z + 7});
  const std::vector<std::string> flags{"rollback", "--data", data.string(), "--subject", "",
                                       "--since",  "1h",     "--box",       box};
  auto dry = flags;
  dry.emplace_back("--dry-run");
  CHECK(sound(dry).find("256 voxels would be put back") != std::string::npos);
  CHECK(viewer.sees(at) == MaterialId{2});
  CHECK(sound(flags).find("256 voxels were put back") != std::string::npos);
  viewer.until([&] { return viewer.sees(at) == kAir; });
  CHECK(viewer.sees({at.x + 4, at.y, at.z}) == MaterialId{2});
  CHECK(sound(flags) == "nothing to put back; 256 voxels were put back before\n");
  CHECK(sound(dry) == "nothing would be put back; 256 voxels were put back before\n");
  auto misspelt = dry;
  misspelt[4] = "malory";
  const std::string nobody = sound(misspelt);
  CHECK(nobody.find("nothing would be put back\nmalory changed nothing in that box since 20") == 0);
  CHECK(nobody.find("Z; subjects that did: (no token) (256 voxels), talusd store rollback (256 voxels)\n") !=
        std::string::npos);
  misspelt.at(8) = text({at.x, at.y + 8, at.z}) + "," + text({at.x + 3, at.y + 9, at.z});
  CHECK(sound(misspelt).find("; nor did any other subject\n") != std::string::npos);
  auto as_tokens_have_it = flags;
  as_tokens_have_it.back() = text(at) + ":" + text({at.x + 3, at.y + 7, at.z + 7});
  CHECK(sound(as_tokens_have_it) == sound(flags));
  const auto history =
      nlohmann::json::parse(sound({"history", "--json", "--data", data.string(), "--at", text(at)}));
  REQUIRE(history.at("changes").size() == 2);
  CHECK(history.at("changes")[0].at("subject") == "");
  CHECK(history.at("changes")[1].at("subject") == "talusd store rollback");
  CHECK(history.at("changes")[1].at("after") == "air");
}

TEST_CASE("a second talusd, and a command that writes, are kept from a directory in use") {
  const ScratchDirectory scratch;
  const fs::path data = scratch / "data";
  const ServerProcess server{editable(data)};
  const ProgramResult second = run_talusd({"--listen", "127.0.0.1:0"}, editable(data));
  CHECK(second.status == 1);
  CHECK(second.err.find("another talusd uses it") != std::string::npos);
  for (const char* const command : {"compact", "rebase"}) {
    CHECK(refused({command, "--data", data.string()}).find("a talusd uses it; stop it first") !=
          std::string::npos);
  }
}

TEST_CASE("backup, import, rebase and restore that are killed leave a sound store, and can be done again") {
  const std::uint64_t seed = seed_of_run();
  CAPTURE(seed);
  std::mt19937_64 random{seed};
  const char* const given = std::getenv("TALUS_KILLS");
  const int kills = given != nullptr ? std::atoi(given) : (kSanitized ? 2 : 5);
  const ScratchDirectory scratch;
  const fs::path data = scratch / "data";
  {
    const ServerProcess server{editable(data)};
    Player player;
    const auto world = player.connect(server.port());
    REQUIRE(world.has_value());
    const VoxelPos at{world->spawn.x & ~31, world->spawn.y, world->spawn.z & ~31};
    for (std::int64_t i = 0; i < 12; ++i) {
      REQUIRE(player.edit(plane({at.x, at.y + i * 37, at.z}, MaterialId{2})).has_value());
    }
  }
  const std::string hash = figures(data).at("hash");
  (void)sound({"export", (scratch / "edits").string(), "--data", data.string()});
  (void)sound({"backup", (scratch / "backup").string(), "--data", data.string()});
  const auto at_random = [&] { return std::chrono::microseconds{random() % 80'000}; };
  int interrupted = 0;
  for (int kill = 0; kill < kills; ++kill) {
    const fs::path target = scratch / ("killed-" + std::to_string(kill));
    if (!run_and_kill({"backup", target.string(), "--data", data.string()}, at_random())) ++interrupted;
    (void)sound({"verify", "--data", data.string()});
    const fs::path restored = scratch / ("restored-" + std::to_string(kill));
    if (fs::exists(target / "manifest")) {
      (void)sound({"restore", target.string(), "--data", restored.string()});
      CHECK(figures(restored).at("hash") == hash);
    } else if (fs::exists(target)) {
      CHECK(refused({"restore", target.string(), "--data", restored.string()}).find("was not finished") !=
            std::string::npos);
    }
  }
  // The same edits again: whatever is there afterwards is that.
  for (int kill = 0; kill < kills; ++kill) {
    if (!run_and_kill({"import", (scratch / "edits").string(), "--data", data.string()}, at_random()))
      ++interrupted;
    (void)sound({"verify", "--data", data.string()});
    CHECK(figures(data).at("hash") == hash);
  }
  for (int kill = 0; kill < kills; ++kill) {
    if (!run_and_kill({"restore", (scratch / "backup").string(), "--replace", "--data", data.string()},
                      at_random())) {
      ++interrupted;
    }
    (void)sound({"verify", "--data", data.string()});
    CHECK(figures(data).at("hash") == hash);
  }
  // Between two worlds that differ by their seed alone. Names of materials are the same.
  std::string other = read_whole(kClassicWorld.second);
  other.replace(other.find("seed = 2019"), 11, "seed = 2020");
  const std::array worlds{std::string{kClassicWorld.second}, scratch.write("other.toml", other)};
  std::size_t next = 1;
  std::string fingerprint = figures(data).at("fingerprint");
  for (int kill = 0; kill < kills; ++kill) {
    if (!run_and_kill({"rebase", "--world", worlds[next], "--data", data.string()}, at_random()))
      ++interrupted;
    (void)sound({"verify", "--data", data.string()});
    const std::string now = figures(data).at("fingerprint");
    if (std::exchange(fingerprint, now) != now) next = 1 - next;
  }
  CHECK(interrupted > 0);
  (void)sound({"rebase", "--world", worlds[next], "--data", data.string()});
  Settings settings = editable(data);
  settings["TALUS_WORLD"] = worlds[next];
  const ServerProcess server{settings};
}

TEST_CASE("a killed pregen is continued, and its land equals the land of a server without pregen") {
  const ScratchDirectory scratch;
  const Settings settings{{"TALUS_WORLD", TALUS_SOURCE_DIR "/core/worlds/alpine.toml"},
                          {"TALUS_GENERATION_PATCH_TILES", "2"}};
  const std::string data = (scratch / "data").string();
  const std::vector<std::string> pregen{"pregen", "--radius", "300", "--data", data};
  const auto finished = [&] {
    const ProgramResult ended = run_talusd(pregen, settings);
    INFO(ended.err);
    CHECK(ended.status == 0);
    return ended.out;
  };
  std::vector<std::string> killed = pregen;
  for (const char* const flag : {"--world", settings.at("TALUS_WORLD").c_str(), "--share", "0.005"}) {
    killed.emplace_back(flag);
  }
  const std::uint64_t seed = seed_of_run();
  CAPTURE(seed);
  std::mt19937_64 random{seed};
  for (int kill = 0; kill < 5; ++kill) {
    CHECK_FALSE(run_and_kill(
        killed, [&] { std::this_thread::sleep_for(std::chrono::milliseconds{50 + random() % 500}); }));
  }
  CHECK_THAT(finished(), Catch::StartsWith("121 of 121 squares are made, 484 columns"));
  CHECK_THAT(finished(), Catch::StartsWith("121 of 121 squares are made, 0 columns"));

  Settings cached = settings;
  cached.emplace("TALUS_DATA", data);
  std::array<std::vector<ContentHash>, 2> seen;
  for (const bool with : {false, true}) {
    const ServerProcess server{with ? cached : settings};
    Player player;
    const auto world = player.connect(server.port());
    REQUIRE(world.has_value());
    for (const std::int32_t x : {-256, 0, 200}) {
      player.move_view({x, world->spawn.y, x / 2}, 2);
      for (std::int32_t cx = -2; cx <= 2; ++cx) {
        for (std::int32_t cz = -2; cz <= 2; ++cz) {
          const auto chunk = player.store.find(
              {{x / 32 + cx, static_cast<std::int32_t>(world->spawn.y / 32), x / 64 + cz}, Lod{}});
          seen[with ? 1 : 0].push_back(chunk == nullptr ? ContentHash{} : content_hash(*chunk));
        }
      }
    }
  }
  CHECK(seen[0] == seen[1]);
  CHECK(std::ranges::count(seen[0], ContentHash{}) < 30);
}
