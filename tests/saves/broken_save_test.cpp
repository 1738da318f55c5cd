// Files that are no saves, not of this program's world, or damaged.
#include <talus/saves/save.h>

#include <sqlite3.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include <catch2/catch.hpp>

#include "saved_land.h"
#include "scratch_directory.h"
#include "seed_of_run.h"

using namespace talus;
using saves::Save;
using Kind = saves::SaveError::Kind;

namespace {

class Broken {
 public:
  Broken() {
    Save save = new_save(file());
    local::Workspace workspace{save.world()};
    REQUIRE(save.apply(workspace, filled({-8, 80, -8}, {20, 120, 8})));
    REQUIRE(save.commit());
  }
  [[nodiscard]] std::filesystem::path file() const { return directory_ / "game.talus"; }
  void run(const std::string& sql) const {
    sqlite3* database = nullptr;
    REQUIRE(sqlite3_open(file().c_str(), &database) == SQLITE_OK);
    const int done = sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr);
    INFO(sqlite3_errmsg(database));
    CHECK(done == SQLITE_OK);
    sqlite3_close(database);
  }
  [[nodiscard]] saves::SaveError error() const {
    const auto save = Save::open(file());
    REQUIRE_FALSE(save);
    CHECK(save.error().message.starts_with(file().string() + ": "));
    CHECK(save.error().message.find('\n') == std::string::npos);
    return save.error();
  }

 private:
  ScratchDirectory directory_;
};

}  // namespace

TEST_CASE("files that are no saves are refused") {
  const ScratchDirectory directory;
  const auto refused = [&](const std::filesystem::path& file) {
    const auto save = Save::open(file);
    REQUIRE_FALSE(save);
    return save.error();
  };
  CHECK(refused(directory / "nothing").kind == Kind::missing);
  CHECK_THAT(refused(directory / "nothing").message, Catch::Contains("No such file"));
  CHECK(refused(directory.path()).kind == Kind::foreign);
  CHECK(refused(directory.write("empty", "")).kind == Kind::foreign);
  CHECK(refused(directory.write("letter", std::string(10'000, 'x'))).kind == Kind::foreign);
  Broken other;
  other.run("PRAGMA application_id = 1");
  CHECK(other.error().kind == Kind::foreign);
  CHECK_THAT(other.error().message, Catch::Contains("is no save of Talus"));
}

TEST_CASE("saves of other formats, generators and fingerprints are refused by name") {
  Broken save;
  save.run("PRAGMA user_version = 2");
  CHECK(save.error().kind == Kind::other);
  CHECK_THAT(save.error().message, Catch::Contains("format 2"));
  save.run("PRAGMA user_version = 1");
  REQUIRE(Save::open(save.file()));
}

TEST_CASE("a save of another generator version or fingerprint says so") {
  const ScratchDirectory directory;
  const auto refused = [&](auto change) {
    saves::WorldSource source = land();
    change(source.saved);
    std::filesystem::remove(directory / "game");
    REQUIRE(saves::SaveFile::create(directory / "game", source.saved));
    const auto save = Save::open(directory / "game");
    REQUIRE_FALSE(save);
    CHECK(save.error().kind == Kind::other);
    return save.error().message;
  };
  CHECK_THAT(refused([](saves::SavedWorld& world) { world.generator = 9; }),
             Catch::Contains("generator version 9, and this program makes version 3"));
  CHECK_THAT(refused([](saves::SavedWorld& world) { world.generator = 1; }),
             Catch::Contains("generator version 1"));
  CHECK_THAT(refused([](saves::SavedWorld& world) { world.fingerprint = std::string(32, '0'); }),
             Catch::Contains("has the fingerprint " + std::string(32, '0')));
  CHECK_THAT(refused([](saves::SavedWorld& world) { world.spec += "unknown = 1\n"; }),
             Catch::Contains("unknown"));
}

TEST_CASE("what other programs change in a save is found") {
  const auto* const change =
      GENERATE("UPDATE chunks SET x = x + 1000", "UPDATE state SET hash = 'no'", "DELETE FROM state",
               "UPDATE world SET spec = spec || '# more'", "DELETE FROM world",
               "UPDATE materials SET name = 'gold' WHERE id = 256", "DELETE FROM materials WHERE id = 2",
               "INSERT INTO files VALUES('more', x'00')", "UPDATE chunks SET runs = x'0000ff'",
               "UPDATE chunks SET y = y + (1 << 40)", "CREATE TABLE more(a)", "DROP TABLE files",
               "CREATE TRIGGER t AFTER UPDATE ON state BEGIN DELETE FROM chunks; END",
               "UPDATE world SET settles = 1", "UPDATE state SET revision = -1");
  INFO(change);
  const Broken save;
  save.run(change);
  CHECK(save.error().kind == Kind::damaged);
}

TEST_CASE("a lost chunk is found") {
  const Broken save;
  save.run(
      "DELETE FROM chunks WHERE x = 0 AND z = 0 AND y = (SELECT max(y) FROM chunks WHERE x = 0 AND z = 0)");
  CHECK(save.error().kind == Kind::damaged);
  CHECK_THAT(save.error().message, Catch::Contains("the hash of its edits is"));
}

TEST_CASE("no damaged byte gives other edits") {
  const Broken save;
  const auto good = Save::open(save.file())->edits().hash();
  const std::string bytes = read_whole(save.file());
  const std::uint64_t seed = seed_of_run();
  INFO("TALUS_SEED=" << seed);
  std::mt19937_64 random{seed};
  const char* const times = std::getenv("TALUS_FLIPS");
  for (int i = 0; i < (times == nullptr ? 150 : std::atoi(times)); ++i) {
    std::string damaged = bytes;
    const std::size_t at = random() % damaged.size();
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << random() % 8));
    if (i % 10 == 0) damaged.resize(at);
    INFO("at " << at);
    std::ofstream{save.file(), std::ios::binary} << damaged;
    std::filesystem::remove(save.file().string() + "-journal");
    const auto opened = Save::open(save.file());
    if (opened) CHECK(opened->edits().hash() == good);  // a byte that nothing reads
  }
}

TEST_CASE("a save that may not be written is refused, and read if asked so") {
  if (geteuid() != 0) return;  // root alone becomes another user
  const Broken save;
  std::filesystem::permissions(save.file().parent_path(), std::filesystem::perms{0755});
  std::filesystem::permissions(save.file(), std::filesystem::perms{0444});
  REQUIRE(seteuid(65'534) == 0);
  const auto written = Save::open(save.file());
  const auto read = Save::open(save.file(), saves::Access::read);
  REQUIRE(seteuid(0) == 0);
  REQUIRE_FALSE(written);
  CHECK(written.error().kind == Kind::read_only);
  CHECK(read);
}
